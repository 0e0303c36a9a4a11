# Draws levels.svg: gnuplot levels.gp
set encoding utf8
set terminal svg enhanced font 'DejaVu Sans,11' fontscale 1.59 linewidth 1.4 dashlength 0.7 size 640,622 background '#FFFFFF'
mark = 1.6
legend_line = 1.4
small = ',8'
medium = ',9'
body = 0.953708
caption = 'NLvib: oscillator with a one-sided elastic stop'
across = 1
upward = 1
set output 'levels.svg'
data = 'levels.gp.dat'
set minussign
set format '%h'
set border 3 lw 0.7 lc rgb '#808080'
set tics out nomirror scale 0.6 font small textcolor rgb '#000000'
set key noautotitle noopaque
set multiplot
unset label
unset arrow
unset object
unset key
set lmargin at screen 0.2133*across
set rmargin at screen 1-0.04*across
set bmargin at screen 0.2315*upward*body
set tmargin at screen (1-0.1393*upward)*body
set xrange [0.85:1.7]
set xtics 0.2
set format x '%h'
set xlabel 'forcing frequency Ω (rad/s)'
set border 7
set x2range [0.135281701628:0.270563403256]
set x2tics 0.02
set x2label 'forcing frequency (Hz)'
set yrange [10:30]
unset logscale y
set format y '%h'
set ytics 5
set label 'forcing amplitude (mN)' at screen 0.055*across, graph 0.5 center rotate
set label 'LPUZ-1' at graph 0.62931, graph 0.20436 center front font small
set label 99 caption at screen 0.02, screen 1 offset 0, -0.8 left font small
plot data index '[LP]' with lines lw 2.11 dt solid lc rgb '#000000', \
     data index '[GR]' with lines lw 2.11 dt (4,4) lc rgb '#009E73', \
     data index '[UZ]' with lines lw 1.64 dt solid lc rgb '#332288', \
     data index '[codimension_two]' with points pt 7 ps 0.72*mark lw 1.2 lc rgb '#000000', \
     NaN notitle
unset label 99
unset label
unset arrow
unset object
unset border
unset tics
unset x2tics
unset colorbox
unset xlabel
unset x2label
unset logscale
set xrange [0:1]
set yrange [0:1]
set lmargin at screen 0.02*across
set rmargin at screen 1-0.02*across
set bmargin at screen 0*upward*body
set tmargin at screen (1-0*upward)*body
set key at screen 0.5867, screen 0.007191*body center bottom horizontal maxcols 2 width 3 Left reverse samplen 2 spacing 1.25*legend_line font small
plot NaN with lines lw 2.11 dt solid lc rgb '#000000' title 'fold (LP)', \
     NaN with lines lw 2.11 dt (4,4) lc rgb '#009E73' title 'grazing (GR)', \
     NaN with lines lw 1.64 dt solid lc rgb '#332288' title 'level (UZ)', \
     NaN with points pt 7 ps 0.72*mark lw 1.2 lc rgb '#000000' title 'codimension two', \
     NaN notitle
unset multiplot
