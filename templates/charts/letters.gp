{{! SPDX-License-Identifier: GPL-3.0-or-later }}
{{! The same with letters, on a terminal (report --show, inspect). }}
reset
set terminal dumb size {{size}} noenhanced
set encoding utf8
set datafile separator comma
set output '{{name}}.txt'
{{#panels}}
unset logscale; set autoscale
{{#log_x}}
set logscale x
{{/log_x}}
{{#log_y}}
set logscale y
{{/log_y}}
set xrange [{{x_low}}:{{x_high}}]; set yrange [{{y_low}}:{{y_high}}]
set xtics ({{#x_ticks}}'{{label}}' {{at}}{{#more}}, {{/more}}{{/x_ticks}})
set ytics ({{#y_ticks}}'{{label}}' {{at}}{{#more}}, {{/more}}{{/y_ticks}})
set xlabel '{{x_label}}'
set title '{{title}}  {{y_label}}'
set key bmargin center vertical
plot {{#curves}}{{^band}}'{{name}}.csv' index {{index}} using 1:2 with {{#line}}lines{{/line}}{{^line}}points{{/line}} title '{{title}}'{{#more}}, \
 {{/more}}{{/band}}{{/curves}}
{{/panels}}
set output
