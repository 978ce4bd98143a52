# Where two bodies touch: rows of contact, each a run of points, filled. No words in the picture: its caption has them.
#   call 'patches.gp' DATA OUTPUT TITLE SIZE STYLES
# DATA: a legend, then x from, x to, y from, y to. SIZE: of the cell, in the unit of the data.
data = ARG1; output = ARG2; cell = ARG4 + 0.0
reset
set encoding utf8
set datafile separator ','
set terminal png medium size 640,640 background rgb '#ffffff'
set output output
unset key
unset tics
set border 15 lc rgb '#808080'
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set size square
set xrange [0:cell]
set yrange [0:cell]
set style fill solid 1 noborder
plot data every ::1 using (($1 + $2) / 2):(($3 + $4) / 2):1:2:3:4 with boxxyerror lc rgb '#1257D0'
set output
