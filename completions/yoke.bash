# bash completion for yoke: what the verbs take is asked of `yoke VERB --help`, so that it is never another
_yoke_options() {
    yoke "$1" --help 2>/dev/null | sed -n 's/^  \(-[a-z], \)\{0,1\}\(--[a-z-]*\).*/\2/p'
}

_yoke_verbs() {
    yoke 2>/dev/null | sed -n '/^Verbs:/,/^$/s/^  \([a-z-]*\) .*/\1/p'
}

_yoke() {
    local word previous verb="" i words
    word=${COMP_WORDS[COMP_CWORD]}
    previous=${COMP_WORDS[COMP_CWORD - 1]}
    [[ $COMP_CWORD -gt 1 ]] && verb=${COMP_WORDS[1]}
    case $previous in
    --format)
        words="text json csv"
        [[ $verb == derive ]] && words="text latex mathml json c"
        [[ $verb == report ]] && words="html pdf"
        COMPREPLY=($(compgen -W "$words" -- "$word"))
        return
        ;;
    --solver)
        COMPREPLY=($(compgen -W "elimination paths both" -- "$word"))
        return
        ;;
    --task)
        COMPREPLY=($(compgen -W "motion function stroke" -- "$word"))
        return
        ;;
    --what)
        COMPREPLY=($(compgen -W "all loops jacobian velocity acceleration points free-bodies newton-euler energy lagrange gears cam centers polygons" -- "$word"))
        return
        ;;
    --method)
        words="reduced newton-euler"
        [[ $verb == simulate ]] && words="dop853 sdirk4 rk4"
        COMPREPLY=($(compgen -W "$words" -- "$word"))
        return
        ;;
    --plot | --profile | --animate | -o | --output)
        COMPREPLY=($(compgen -f -- "$word"))
        return
        ;;
    esac
    if [[ -z $verb ]]; then
        COMPREPLY=($(compgen -W "$(_yoke_verbs) help --quiet --help --version" -- "$word"))
    elif [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$(_yoke_options "$verb")" -- "$word"))
    elif [[ $verb == explain ]]; then
        COMPREPLY=($(compgen -W "$(yoke explain 2>/dev/null | cut -d' ' -f1)" -- "$word"))
    elif [[ $verb == new ]]; then
        COMPREPLY=($(compgen -W "$(yoke new 2>/dev/null | sed -n 's/^  \([a-z0-9-]*\) .*/\1/p')" -- "$word"))
    elif [[ $previous != --* || $previous == --all || $previous == --quiet ]]; then
        compopt -o filenames 2>/dev/null
        COMPREPLY=($(compgen -f -X '!*.@(yaml|yml)' -- "$word") $(compgen -d -- "$word"))
    fi
}
complete -F _yoke yoke
