# SPDX-License-Identifier: GPL-3.0-or-later
# Panels of curves, a legend below all of them. By hand: cd figures && gnuplot {{name}}.gp
reset
set terminal svg size {{width}},{{height}} noenhanced font 'Liberation Sans,{{font}}' background '#ffffff'
set encoding utf8
set datafile separator comma
set output '{{name}}.svg'
set multiplot
{{> charts/style}}
{{#panels}}

set lmargin at screen {{left}}; set rmargin at screen {{right}}
set tmargin at screen {{top}}; set bmargin at screen {{bottom}}
unset logscale; unset arrow; unset label; set autoscale
{{#log_x}}
set logscale x
{{/log_x}}
{{#log_y}}
set logscale y
{{/log_y}}
set xrange [{{x_low}}:{{x_high}}]; set yrange [{{y_low}}:{{y_high}}]
set xtics nomirror offset 0,0.45 ({{#x_ticks}}'{{label}}' {{at}}{{#more}}, {{/more}}{{/x_ticks}})
set ytics nomirror ({{#y_ticks}}'{{^bare}}{{label}}{{/bare}}' {{at}}{{#more}}, {{/more}}{{/y_ticks}})
set xlabel '{{x_label}}' offset 0,0.9
set label '{{y_label}}' at screen {{y_label_x}}, graph 0.5 center rotate by 90
set label '{{title}}' at graph 0, screen {{title_y}} left
{{#marks}}
{{#vertical}}
set arrow from {{at}}, graph 0 to {{at}}, graph 1 nohead lc rgb ink lw 1 dt 3 back
set label '{{name}}' at screen {{name_x}}, screen {{mark_y}} left textcolor rgb ink
{{/vertical}}
{{#horizontal}}
set arrow from graph 0, first {{at}} to graph 1, first {{at}} nohead lc rgb ink lw 1 dt 3 back
set label '{{name}}' at graph 1, first {{at}} left offset 0.5,0 textcolor rgb ink
{{/horizontal}}
{{/marks}}
plot {{#curves}}'{{name}}.csv' index {{index}} {{#line}}using 1:2 with lines lc rgb '{{colour}}' lw {{width}} dt {{dash}}{{/line}}{{#band}}using 1:2:3 with filledcurves lc rgb '{{colour}}'{{/band}}{{#points
}}using 1:2 with points lc rgb '{{colour}}' pt {{marker}}{{/points}}{{#bars}}using 1:2:3:4 with yerrorbars lc rgb '{{colour}}' pt {{marker}}{{/bars}}{{#dots}}using 1:2:3:4 with xerrorbars lc rgb '{{colour}}' pt {{marker}} lw 2{{/dots}} notitle{{#more}}, \
 {{/more}}{{/curves}}
{{/panels}}
{{#has_legend}}

# The legend
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0; set tmargin at screen {{legend_y}}
unset logscale; unset arrow; unset label; unset border; unset tics; unset xlabel; unset ylabel
set xrange [0:1]; set yrange [0:1]
set key at screen {{legend_x}}, {{legend_y}} {{#legend_beside}}left{{/legend_beside}}{{^legend_beside}}center{{/legend_beside}} top horizontal Left reverse maxcols {{legend_columns}} samplen 2
plot {{#legend}}2 {{#line}}with lines lc rgb '{{colour}}' lw {{width}} dt {{dash}}{{/line}}{{#band}}with lines lc rgb '#dcdcdc' lw 8{{/band}}{{^drawn_lines}}with points lc rgb '{{colour}}' pt {{marker}}{{/drawn_lines}} title '{{title}}'{{#more}}, \
 {{/more}}{{/legend}}
{{/has_legend}}
unset multiplot
set output
