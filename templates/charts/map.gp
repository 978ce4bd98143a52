# SPDX-License-Identifier: GPL-3.0-or-later
# A map's heights with its contact, and a section. By hand: cd figures && gnuplot {{name}}.gp
reset
set terminal svg size 800,380 noenhanced font 'Liberation Sans,15' background '#ffffff' standalone
set encoding utf8
set datafile separator comma
set output '{{name}}.svg'
set multiplot
{{> charts/style}}
unset grid; set style fill solid 1
set tmargin at screen 0.905; set bmargin at screen 0.247

# Heights in greys, so that what touches stands out; 48 of them, as more would double the picture's size
set palette maxcolors 48 defined (0 '#3a3a3a', 1 '#fafafa')
set lmargin at screen 0.095; set rmargin at screen 0.40125
set colorbox user origin screen 0.42, 0.247 size screen 0.016, 0.658 border
set cbtics nomirror scale 0.6 offset -0.6,0 textcolor rgb ink
set xrange [0:{{side}}]; set yrange [0:{{side}}]
# about four tics a side, of 1, 2 or 5 times a power of ten
nice(s) = (power = 10**floor(log10(s)), s < 1.5*power ? power : s < 3.5*power ? 2*power : s < 7.5*power ? 5*power : 10*power)
set xtics nice({{side}}/4.); set ytics nice({{side}}/4.)
set format '%.3g'
set xlabel '{{along}} ({{length_unit}})' offset 0,0.6
set label '{{across}} ({{length_unit}})' at screen 0.02, graph 0.5 center rotate by 90
set label '{{title}}' at screen 0.095, screen 0.965 left
set label 'height (µm)' at screen 0.42, screen 0.945 left
set label '■ in contact' at screen 0.095, screen 0.05 left textcolor rgb '#cc5500'
{{#flows}}
set label '■ yielded, at the hardness' at screen 0.24, screen 0.05 left textcolor rgb '#1257d0'
{{/flows}}
set arrow from 0, {{section}} to {{side}}, {{section}} nohead lc rgb ink lw 1 dt 2 front
plot '{{name}}.csv' index 0 nonuniform matrix using 1:2:3 with image notitle

# What touches, over it: what does not is left out
unset label; unset arrow; unset colorbox; unset xtics; unset ytics; unset xlabel; unset border
set palette maxcolors 2 defined (1 '#cc5500', 2 '#1257d0')
set cbrange [1:2]; set xrange [-0.5:{{cells}}-0.5]; set yrange [-0.5:{{cells}}-0.5]
plot '{{name}}.csv' index 1 using 1:2:3 with image notitle

{{> charts/style}}
set lmargin at screen 0.60; set rmargin at screen 0.975
set xtics nomirror nice({{side}}/4.); set ytics nomirror autofreq
set xrange [0:{{side}}]; set yrange [0:*]
set xlabel '{{along}} along the dashed line ({{length_unit}})' offset 0,0.6
set label 'pressure{{#has_material}} (MPa){{/has_material}}{{^has_material}} / E′{{/has_material}}' at screen 0.525, graph 0.5 center rotate by 90
{{#hardness}}
set arrow from graph 0, first {{hardness}} to graph 1, first {{hardness}} nohead lc rgb '#1257d0' lw 1 dt 3 front
set label 'hardness' at graph 1, screen 0.945 right textcolor rgb '#1257d0'
{{/hardness}}
plot '{{name}}.csv' index 2 using 1:2 with lines lc rgb '#cc5500' lw 1.4 notitle
unset multiplot
set output
