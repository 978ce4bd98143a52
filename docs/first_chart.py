# SPDX-License-Identifier: GPL-3.0-or-later
# The report's first chart from results.json alone, in SI: python3 first_chart.py OUT/results.json | gnuplot > chart.svg
import json, sys
run = json.load(open(sys.argv[1]))
asked = ([a["quantity"] for a in run.get("answers", []) if "quantity" in a] +
         [s["measured"]["quantity"] for s in run["surfaces"] if "measured" in s] + [run["comparison"]["quantity"]])[0]
curves = [(s["surface"], "lines", s, s["models"].get(run["leading"], {})) for s in run["surfaces"]]
curves += [("measured", "points", s, s["measured"]) for s in run["surfaces"] if "measured" in s]
print(f"set terminal svg noenhanced; set logscale; set xlabel 'pressure (Pa)'; set ylabel '{asked}'\nplot",
      ", ".join("'-' with {} title '{}'".format(style, title.replace("'", "''")) for title, style, _, _ in curves))
for _, _, surface, curve in curves:
    modulus = surface.get("effective_modulus_Pa") or run["scene"]["effective_modulus_Pa"]
    print(*(f"{load * modulus!r} {value!r}" for load, value in
            zip(curve.get("load_over_AnEp", []), curve.get(asked, [])) if value), "e", sep="\n")
