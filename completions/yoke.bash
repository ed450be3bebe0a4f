# bash completion for yoke
_yoke() {
    local word previous verb="" i
    word=${COMP_WORDS[COMP_CWORD]}
    previous=${COMP_WORDS[COMP_CWORD - 1]}
    for ((i = 1; i < COMP_CWORD; i++)); do
        case ${COMP_WORDS[i]} in
        check | solve | sweep | draw | explain | derive | gears | cam | simulate | report | code)
            verb=${COMP_WORDS[i]}
            break
            ;;
        esac
    done
    case $previous in
    --format)
        local formats="text json csv"
        [[ $verb == derive ]] && formats="text latex mathml json c"
        COMPREPLY=($(compgen -W "$formats" -- "$word"))
        return
        ;;
    --what)
        COMPREPLY=($(compgen -W "all loops jacobian velocity acceleration points free-bodies newton-euler energy lagrange gears cam" -- "$word"))
        return
        ;;
    --plot | --profile | -o | --output)
        COMPREPLY=($(compgen -f -- "$word"))
        return
        ;;
    --at | --rate | --accel | --param | --effort | --time | --over | --of | --steps | --poses | --trace | --cam | --tolerance | --cutter | --limits | --speed | --check) return ;;
    esac
    if [[ $previous == --compare ]]; then
        COMPREPLY=($(compgen -W "harmonic double-harmonic cycloidal modified-trapezoid modified-sine 3-4-5 4-5-6-7 parabolic constant-velocity" -- "$word"))
        return
    fi
    local pose="--at --rate --accel --time --param --effort" always="--quiet --help --version"
    case $verb in
    "") COMPREPLY=($(compgen -W "check solve sweep draw cam derive explain help $always" -- "$word")) ; return ;;
    explain) COMPREPLY=($(compgen -W "$(yoke explain 2>/dev/null | cut -d' ' -f1) $always" -- "$word")) ; return ;;
    esac
    if [[ $word == -* ]]; then
        case $verb in
        check) COMPREPLY=($(compgen -W "--param --format --output $always" -- "$word")) ;;
        solve) COMPREPLY=($(compgen -W "$pose --all --format --output $always" -- "$word")) ;;
        sweep) COMPREPLY=($(compgen -W "$pose --over --steps --of --plot --format --output $always" -- "$word")) ;;
        cam) COMPREPLY=($(compgen -W "--param --cam --steps --plot --profile --tolerance --cutter --compare --limits --speed --format --output $always" -- "$word")) ;;
        draw) COMPREPLY=($(compgen -W "$pose --over --poses --trace --no-labels --output $always" -- "$word")) ;;
        derive) COMPREPLY=($(compgen -W "$pose --what --numbers --check --format --output $always" -- "$word")) ;;
        *) COMPREPLY=($(compgen -W "$always" -- "$word")) ;;
        esac
    else
        compopt -o filenames 2>/dev/null
        COMPREPLY=($(compgen -f -X '!*.@(yaml|yml)' -- "$word") $(compgen -d -- "$word"))
    fi
}
complete -F _yoke yoke
