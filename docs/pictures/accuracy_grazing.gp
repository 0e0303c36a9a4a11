# Draws accuracy_grazing.png: gnuplot accuracy_grazing.gp
set encoding utf8
set terminal pngcairo enhanced font 'DejaVu Sans,11' fontscale 2.6 linewidth 3 pointscale 3.4 dashlength 0.7 size 1360,1020 background '#FFFFFF'
mark = 1
set output 'accuracy_grazing.png'
set minussign
set format '%h'
set border 3 lw 0.7 lc rgb '#808080'
set tics out nomirror scale 0.6 textcolor rgb '#000000'
set key noautotitle noopaque
$dopri5 << EOD
0.00010413725 4.50217641e-12
EOD
$exact << EOD
8.2775e-07 3.01980663e-14
EOD
$rk4 << EOD
3.61278e-05 8.29473112e-09
0.0001273464 3.33946204e-11
0.00055613656 1.5187851e-13
0.00221392728 3.7658765e-13
0.00873006768 1.93711713e-12
EOD
$front << EOD
8.2775e-07 3.01980663e-14
EOD
$allowed << EOD
1e-07 2.24399475e-10
0.01 2.24399475e-10
EOD
set lmargin at screen 0.18
set rmargin at screen 0.96
set bmargin at screen 0.28
set tmargin at screen 0.96
set key at screen 0.57, screen 0.01 center bottom horizontal maxcols 2 Left reverse samplen 2 font ',9'
set logscale xy
set format xy '10^{%L}'
set xrange [1e-07:0.01]
set yrange [1e-14:1e-08]
set xlabel 'computing time per forcing period (s)'
set label 'largest error of an impact time (s)' at screen 0.03, graph 0.5 center rotate
plot $dopri5 using 1:2 with linespoints lw 1.5 pt 9 ps 1.3*mark lc rgb '#009E73' title 'dopri5', \
     $exact using 1:2 with linespoints lw 1.5 pt 7 ps 1.3*mark lc rgb '#D55E00' title 'exact', \
     $rk4 using 1:2 with linespoints lw 1.5 pt 5 ps 1.3*mark lc rgb '#0072B2' title 'rk4', \
     $front using 1:2 with points pt 6 ps 1.9*mark lw 1.5 lc rgb '#000000' title 'beaten by none', \
     $allowed using 1:2 with lines dt (8,4) lc rgb '#999999' title 'solver.tolerance', \
     NaN notitle
