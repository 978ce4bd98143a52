#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes every scan below this directory, and the picture of README.md, again. ROUGHCONTACT names the program, by its whole
# path (default: the one in PATH).
set -eu
cd "$(dirname "$0")"
synth() { "${ROUGHCONTACT:-roughcontact}" synth "$@"; }

# chapter6: the thesis's table 6.2 (roughness, alpha, gamma, scatter), the scan lengths these imply, a stylus's spacing and
# its short-wavelength cut-off
synth --lambda-s 8um --seed 3 --alpha 0.13  --gamma 1.6 --rq 0.24um --scatter 0.3322 --length 0.31mm --points 1240 -o chapter6/surface-1.csv
synth --lambda-s 8um --seed 1 --alpha 0.085 --gamma 1.5 --rq 0.34um --scatter 0.4134 --length 0.30mm --points 1200 -o chapter6/surface-2.csv
synth --lambda-s 8um --seed 1 --alpha 0.037 --gamma 1.4 --rq 1.05um --scatter 0.4053 --length 0.67mm --points 2680 -o chapter6/surface-3.csv
synth --lambda-s 8um --seed 4 --alpha 0.006 --gamma 1.0 --rq 5.82um --scatter 0.0678 --length 1.07mm --points 4280 -o chapter6/surface-4.csv

# connector: contact surfaces as plated and worn, three scans of each
synth --lambda-s 2.5um --seed 11 --alpha 0.06 --gamma 1.55 --scatter 0.28 --length 0.40mm --points 1600 -o connector/as-plated-1.csv
synth --lambda-s 2.5um --seed 12 --alpha 0.06 --gamma 1.55 --scatter 0.28 --length 0.40mm --points 1600 -o connector/as-plated-2.csv
synth --lambda-s 2.5um --seed 13 --alpha 0.06 --gamma 1.55 --scatter 0.28 --length 0.40mm --points 1600 -o connector/as-plated-3.csv
synth --lambda-s 2.5um --seed 21 --alpha 0.02 --gamma 1.35 --scatter 0.28 --length 0.40mm --points 1600 -o connector/worn-1.csv
synth --lambda-s 2.5um --seed 22 --alpha 0.02 --gamma 1.35 --scatter 0.28 --length 0.40mm --points 1600 -o connector/worn-2.csv
synth --lambda-s 2.5um --seed 23 --alpha 0.02 --gamma 1.35 --scatter 0.28 --length 0.40mm --points 1600 -o connector/worn-3.csv

# thermal-interface: the two sides of a bare metal joint
synth --lambda-s 8um --seed 21 --alpha 0.03 --gamma 1.40 --rq 0.80um --scatter 0.28 --length 0.60mm --points 1200 -o thermal-interface/cold-plate.csv
synth --lambda-s 8um --seed 22 --alpha 0.06 --gamma 1.40 --rq 1.60um --scatter 0.28 --length 0.60mm --points 1200 -o thermal-interface/heat-spreader.csv

# lapped-map: an areal map of a lapped face, 16 bits a height
synth --map --seed 5 --points 256 --length 0.512mm --gamma 1.25 --lambda-s 20um --rq 0.25um -o lapped-map/lapped.sdf

# what the README shows: the whole reports of three of them, and the first chart of the connector's
made=$(mktemp -d)
trap 'rm -r "$made"' EXIT
for name in chapter6 connector lapped-map; do
    "${ROUGHCONTACT:-roughcontact}" report "$name" -o "$made/$name" >"$made/$name.txt"
    rm -rf "../docs/sample/$name"
    mkdir -p "../docs/sample/$name/figures"
    cp "$made/$name/report.md" "$made/$name/view.json" "../docs/sample/$name"
    cp "$made/$name/figures/"*.svg "../docs/sample/$name/figures"
done
cp "$made/connector/figures/answer.svg" picture.svg
