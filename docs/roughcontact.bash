# SPDX-License-Identifier: GPL-3.0-or-later
# bash completion of roughcontact. Written by `roughcontact help --completion`.
_roughcontact()
{
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
    local options='' kind=nothing words='' argument='' before=''
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W 'report direct plan inspect synth models materials self-test help --help --version' -- "$word")
        return
    fi
    if [[ $word == '=' ]]; then # --option=, which bash takes apart
        word=''
    elif [[ $previous == '=' ]]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    case ${COMP_WORDS[1]} in
    report)
        options='--output= -o --jobs= -j --show -s --no-cost --check --brief --json --verbose -v --material= -m --effects= -e --tolerance= -t --x-unit= --z-unit= --help -h --usage'
        case $previous in
        --output | -o) kind=directories words='' ;;
        --jobs | -j) kind=nothing words='' ;;
        --material | -m) kind=words words='tin copper brass bronze gold silver nickel aluminium steel hard-gold beryllium-copper copper-nickel-silicon solder indium' ;;
        --effects | -e) kind=list words='auto plasticity separation electrical thermal scale-dependent convergence uncertainty direct gap film plating heating' ;;
        --tolerance | -t) kind=nothing words='' ;;
        --x-unit) kind=words words='m mm um nm angstrom in uin mil' ;;
        --z-unit) kind=words words='m mm um nm angstrom in uin mil' ;;
        *) kind=directories words='' argument=1 ;;
        esac ;;
    direct)
        options='--output= -o --jobs= -j --show -s --no-cost --check --brief --json --verbose -v --material= -m --effects= -e --tolerance= -t --x-unit= --z-unit= --help -h --usage'
        case $previous in
        --output | -o) kind=directories words='' ;;
        --jobs | -j) kind=nothing words='' ;;
        --material | -m) kind=words words='tin copper brass bronze gold silver nickel aluminium steel hard-gold beryllium-copper copper-nickel-silicon solder indium' ;;
        --effects | -e) kind=list words='auto plasticity separation electrical thermal scale-dependent convergence uncertainty direct gap film plating heating' ;;
        --tolerance | -t) kind=nothing words='' ;;
        --x-unit) kind=words words='m mm um nm angstrom in uin mil' ;;
        --z-unit) kind=words words='m mm um nm angstrom in uin mil' ;;
        *) kind=directories words='' argument=1 ;;
        esac ;;
    plan)
        options='--brief --json --material= -m --effects= -e --tolerance= -t --x-unit= --z-unit= --help -h --usage'
        case $previous in
        --material | -m) kind=words words='tin copper brass bronze gold silver nickel aluminium steel hard-gold beryllium-copper copper-nickel-silicon solder indium' ;;
        --effects | -e) kind=list words='auto plasticity separation electrical thermal scale-dependent convergence uncertainty direct gap film plating heating' ;;
        --tolerance | -t) kind=nothing words='' ;;
        --x-unit) kind=words words='m mm um nm angstrom in uin mil' ;;
        --z-unit) kind=words words='m mm um nm angstrom in uin mil' ;;
        *) kind=directories words='' argument=1 ;;
        esac ;;
    inspect)
        options='--json --no-chart --chart --x-unit= --z-unit= --quantity= --column= --level= --lambda-s= --lambda-c= --fit= --limits --help -h --usage'
        case $previous in
        --x-unit) kind=words words='m mm um nm angstrom in uin mil' ;;
        --z-unit) kind=words words='m mm um nm angstrom in uin mil' ;;
        --quantity) kind=words words='height slope' ;;
        --column) kind=nothing words='' ;;
        --level) kind=words words='none mean line parabola circle robust' ;;
        --lambda-s) kind=nothing words='' ;;
        --lambda-c) kind=nothing words='' ;;
        --fit) kind=words words='auto thesis' ;;
        *) kind=files words='' argument=1 ;;
        esac ;;
    synth)
        options='--alpha= -a --gamma= -g --rq= -r --length= -l --points= -n --scatter= -c --lambda-s= -s --seed= -d --output= -o --help -h --usage'
        case $previous in
        --alpha | -a) kind=nothing words='' ;;
        --gamma | -g) kind=nothing words='' ;;
        --rq | -r) kind=nothing words='' ;;
        --length | -l) kind=nothing words='' ;;
        --points | -n) kind=nothing words='' ;;
        --scatter | -c) kind=nothing words='' ;;
        --lambda-s | -s) kind=nothing words='' ;;
        --seed | -d) kind=nothing words='' ;;
        --output | -o) kind=files words='' ;;
        *) kind=nothing words='' argument=1 ;;
        esac ;;
    models)
        options='--json --help -h --usage'
        case $previous in
        *) kind=nothing words='' argument=1 ;;
        esac ;;
    materials)
        options='--json --help -h --usage'
        case $previous in
        *) kind=nothing words='' argument=1 ;;
        esac ;;
    self-test)
        options='--json --verbose -v --help -h --usage'
        case $previous in
        *) kind=nothing words='' argument=1 ;;
        esac ;;
    help)
        options='--man --completion --help -h --usage'
        case $previous in
        *) kind=words words='report direct plan inspect synth models materials self-test help' argument=1 ;;
        esac ;;
    esac
    if [[ -n $argument && $word == -* ]]; then
        kind=words words=$options
        compopt -o nospace 2>/dev/null
    fi
    case $kind in
    list)
        [[ $word == *,* ]] && before=${word%,*},
        mapfile -t COMPREPLY < <(compgen -P "$before" -W "$words" -- "${word##*,}") ;;
    words) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word") ;;
    files)
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
        compopt -o filenames 2>/dev/null ;;
    directories)
        mapfile -t COMPREPLY < <(compgen -d -- "$word")
        compopt -o filenames 2>/dev/null ;;
    esac
    if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == -* && ${COMPREPLY[0]} != *= ]]; then
        COMPREPLY[0]+=' '
    fi
}
complete -F _roughcontact roughcontact
