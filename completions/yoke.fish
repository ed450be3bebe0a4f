# fish completion for yoke: what the verbs take is asked of `yoke VERB --help`, so that it is never another
function __yoke_verbs
    yoke 2>/dev/null | sed -n '/^Verbs:/,/^$/s/^  \([a-z-]*\)  *\(.*\)/\1\t\2/p'
end
function __yoke_options
    set -l words (commandline -opc)
    yoke $words[2] --help 2>/dev/null | sed -n 's/^  \(-[a-z], \)\{0,1\}\(--[a-z-]*\)[^ ]* *\(.*\)/\2\t\3/p'
end
complete -c yoke -n "test (count (commandline -opc)) -eq 1" -f -a "(__yoke_verbs)"
complete -c yoke -n "test (count (commandline -opc)) -gt 1; and string match -q -- '-*' (commandline -ct)" -a "(__yoke_options)"
complete -c yoke -n "__fish_seen_subcommand_from explain" -x -a "(yoke explain 2>/dev/null | string split -f1 ' ')"
complete -c yoke -n "__fish_seen_subcommand_from new" -x -a "(yoke new 2>/dev/null | string match -rg '^  ([a-z0-9-]+) ')"
