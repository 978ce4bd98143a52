# SPDX-License-Identifier: GPL-3.0-or-later
# bash completion of roughcontact; tests/cli/test_manual.c holds its words to the tables of the program.
_roughcontact()
{
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
    local commands='report direct plan init inspect compare synth models materials'
    local scene='--material= -m --effects= -e --tolerance= -t --accuracy= --budget= --x-unit= --z-unit='
    local options='' kind=nothing words='' argument='' before=''
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W "$commands --help --version" -- "$word")
        return
    fi
    if [[ $word == '=' ]]; then # --option=, which bash takes apart
        word=''
    elif [[ $previous == '=' ]]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    case $command in
    report | direct)
        options="--output= -o --jobs= -j --show -s --no-cost --check --brief --template= --export= --json --verbose -v $scene"
        kind=directories ;;
    plan)
        options="--json $scene"
        kind=directories ;;
    inspect)
        options='--json --chart --x-unit= --z-unit= --column= --lambda-s= --lambda-c='
        kind=files ;;
    init) kind=directories ;;
    compare)
        options='--json --markdown --html'
        kind=directories ;;
    synth)
        options='--alpha= -a --gamma= -g --rq= -r --length= -l --points= -n --scatter= -c --lambda-s= -s --map --seed= -d'
        options+=' --output= -o' ;;
    models | materials) options='--json' ;;
    esac
    case "$command $previous" in # the value of an option
    'synth --output' | 'synth -o') kind=files ;;
    *' --template') kind=files ;;
    *' --output' | *' -o') kind=directories ;;
    *' --material' | *' -m')
        kind=words
        words='tin copper brass bronze gold silver nickel aluminium steel carbon-steel hard-gold'
        words+=' beryllium-copper copper-nickel-silicon solder indium' ;;
    *' --effects' | *' -e')
        kind=list
        words='auto plasticity separation electrical thermal scale-dependent stiffness last-scale convergence uncertainty direct gap film'
        words+=' plating heating shape' ;;
    *' --x-unit' | *' --z-unit') kind=words words='m mm um nm angstrom in uin mil' ;;
    *' --jobs' | *' -j' | *' --tolerance' | *' -t' | *' --accuracy' | *' --budget' | *' --column' | *' --lambda-'[sc] | 'synth -'[agrlncsd] | \
        'synth --'[agrlps]*) kind=nothing ;;
    *) argument=1 ;;
    esac
    if [[ -n $argument && $word == -* ]]; then
        kind=words words="$options --help -h --usage"
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
