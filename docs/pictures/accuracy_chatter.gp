# Draws accuracy_chatter.png: gnuplot accuracy_chatter.gp
set encoding utf8
set terminal pngcairo enhanced font 'DejaVu Sans,11' fontscale 2.6 linewidth 3 pointscale 3.4 dashlength 0.7 size 1360,1020 background '#FFFFFF'
mark = 1
set output 'accuracy_chatter.png'
set minussign
set format '%h'
set border 3 lw 0.7 lc rgb '#808080'
set tics out nomirror scale 0.6 textcolor rgb '#000000'
set key noautotitle noopaque
$dopri5 << EOD
0.000202990886 0.000128156605
0.000481361272 9.28771495e-07
0.00108244389 8.43908254e-09
0.00346904957 9.16914322e-11
0.00711127221 1.80033766e-12
EOD
$exact << EOD
1.59141905e-05 1.54321e-14
EOD
$fehlberg78 << EOD
0.000216501615 0.000116431211
0.000327090058 8.28141383e-08
0.000584624546 2.92140623e-09
0.000982993574 3.49529294e-11
0.0017265428 3.40616424e-13
EOD
$rk4 << EOD
0.000174789502 2.57788598e-05
0.000657416273 1.03478157e-07
0.00272615531 4.00141031e-10
0.01147773 1.74904535e-12
0.0440874899 1.139977e-12
0.181146548 3.99458244e-13
0.769931732 2.60891309e-12
EOD
$front << EOD
1.59141905e-05 1.54321e-14
EOD
$allowed << EOD
1e-05 2.22020682e-11
1 2.22020682e-11
EOD
set lmargin at screen 0.18
set rmargin at screen 0.96
set bmargin at screen 0.28
set tmargin at screen 0.96
set key at screen 0.57, screen 0.01 center bottom horizontal maxcols 2 Left reverse samplen 2 font ',9'
set logscale xy
set format xy '10^{%L}'
set xrange [1e-05:1]
set yrange [1e-14:0.001]
set xlabel 'computing time per forcing period (s)'
set label 'largest error of an impact time (s)' at screen 0.03, graph 0.5 center rotate
plot $dopri5 using 1:2 with linespoints lw 1.5 pt 9 ps 1.3*mark lc rgb '#009E73' title 'dopri5', \
     $exact using 1:2 with linespoints lw 1.5 pt 7 ps 1.3*mark lc rgb '#D55E00' title 'exact', \
     $fehlberg78 using 1:2 with linespoints lw 1.5 pt 13 ps 1.3*mark lc rgb '#CC79A7' title 'fehlberg78', \
     $rk4 using 1:2 with linespoints lw 1.5 pt 5 ps 1.3*mark lc rgb '#0072B2' title 'rk4', \
     $front using 1:2 with points pt 6 ps 1.9*mark lw 1.5 lc rgb '#000000' title 'beaten by none', \
     $allowed using 1:2 with lines dt (8,4) lc rgb '#999999' title 'solver.tolerance', \
     NaN notitle
