#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# sh growth.sh PROGRAM [ROW]: how the time of whole reports on tin grows with what they are of, the table of
# docs/limits.md: the least of two runs on one thread, without gnuplot's, and its stages of more than 5 ms at last.
# Aimed at: exponents of 1.05 or less, of a map's side 2.4. ROW: a word of one row's name, such as map.
set -eu
program=$1 wanted=${2-}
place=$(mktemp -d "${TMPDIR:-/tmp}/roughcontact-bench-XXXXXX")
trap 'rm -rf "$place"' EXIT

# COUNT POINTS LOADS KIND: makes $place/d, of one spacing whatever the length, of a law so flat that a stack is visited
# far down; together: all scans are of one surface.
make_scans() {
    rm -rf "$place/d" && mkdir "$place/d"
    printf 'material: tin\nload: {from: 1e-6, to: 0.1, points: %s}\neffects: [plasticity, separation, electrical, %s\n' \
        "$3" 'thermal, convergence]' >"$place/d/scene.yaml"
    [ "$4" != together ] || echo "surfaces: [{name: all, file: '*.csv'}]" >>"$place/d/scene.yaml"
    for i in $(seq "$1"); do
        seed=$i # not of every seed can a profile be made level
        if [ "$4" = map ]; then
            "$program" synth --map -n "$2" -l "${2}um" -o "$place/d/$i.sdf"
        else
            until "$program" synth -g 1.2 -n "$2" -l "$(($2 / 4))um" -d "$seed" -o "$place/d/$i.csv" 2>/dev/null; do
                seed=$((seed + 1000))
            done
        fi
    done
}

# THREADS: the stages' seconds of a report, least of two runs, as lines "name,seconds"
time_report() {
    for run in 1 2; do
        "$program" report "$place/d" -o "$place/out" -j "$1" --verbose 2>&1 |
            sed -n '/^stage  /,/^largest/s/^\(.*[^ ]\)  *\([0-9.]*\)$/\1,\2/p'
    done | awk -F, '!($1 in least) {name[++n] = $1; least[$1] = $2} $2 < least[$1] {least[$1] = $2}
                    END {for (i = 1; i <= n; i++) if (name[i] !~ /^(gnuplot|total|stage)$/) print name[i] "," least[name[i]]}'
}

# NAME KIND COUNT POINTS LOADS SIZE...: the size is in the place of what is ''. Of a fixed part and c size^k, at sizes a
# constant factor apart, the last column is k: what the fixed part is drops out of the differences.
row() {
    name=$1 kind=$2 count=$3 points=$4 loads=$5
    shift 5
    case $name in *"$wanted"*) ;; *) return ;; esac
    for size; do
        make_scans "${count:-$size}" "${points:-$size}" "${loads:-$size}" "$kind"
        time_report 1 | sed "s/^/$size,/"
    done | awk -F, -v row="$name" '
        !($1 in of) {of[$1] = ++sizes; size[sizes] = $1}
        !($2 in seen) {seen[$2] = 1; stage[++stages] = $2}
        {second[$2, of[$1]] = $3}
        END {for (i = stages; i > 0; i--) {
            s = stage[i]
            if (second[s, 3] <= 0.005 && s !~ /^total/) continue
            printf "| %s |", s ~ /^total/ ? row : "  " s
            for (k = 1; k <= 3; k++) printf " %s: %.4g s |", size[k], second[s, k]
            last = second[s, 3] - second[s, 2]; first = second[s, 2] - second[s, 1]
            if (last > 0 && first > 0) printf " %.2f |\n", log(last / first) / log(size[3] / size[2]); else print " - |"
        }}'
}

row 'scans of 1000 points' together '' 1000 31 10 100 1000
row 'surfaces of 1000 points' apart '' 1000 31 10 100 1000
row 'points of one scan' apart 1 '' 31 10000 100000 1000000
row 'points a side of one map' map 1 '' 31 64 256 1024
row 'loads on one scan' apart 1 4000 '' 100 1000 10000
case threads in *"$wanted"*)
    make_scans 100 1000 31 apart
    for threads in 1 2 4; do
        time_report "$threads" | sed -n "s/^total.*,/| $threads threads on 100 surfaces: /p"
    done ;;
esac
