# SPDX-License-Identifier: GPL-3.0-or-later
# The report's first chart from results.json alone: python3 first_chart.py OUT/results.json chart.svg (needs matplotlib)
import json, sys
import matplotlib.pyplot as plot
run = json.load(open(sys.argv[1]))
asked = ([a["quantity"] for a in run.get("answers", []) if "quantity" in a] +
         [s["measured"]["quantity"] for s in run["surfaces"] if "measured" in s] + [run["comparison"]["quantity"]])[0]
for surface in run["surfaces"]:
    modulus = surface.get("effective_modulus_Pa") or run["scene"]["effective_modulus_Pa"]
    for curve, style, name in ((surface["models"].get(run["leading"], {}), "-", surface["surface"]),
                               (surface.get("measured", {}), "o", surface["surface"] + ", measured")):
        points = [(load * modulus, y) for load, y in zip(curve.get("load_over_AnEp", []), curve.get(asked, [])) if y]
        if points:
            plot.loglog(*zip(*points), style, label=name)
plot.xlabel("pressure (Pa)"), plot.ylabel(asked), plot.legend()
plot.savefig(sys.argv[2])
