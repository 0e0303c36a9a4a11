# Draws yigit_sensitivity.png: gnuplot yigit_sensitivity.gp
set encoding utf8
set terminal pngcairo enhanced font 'DejaVu Sans,11' fontscale 2.6 linewidth 3 pointscale 3.4 dashlength 0.7 size 1360,1754 background '#FFFFFF'
mark = 1
set output 'yigit_sensitivity.png'
set minussign
set format '%h'
set border 3 lw 0.7 lc rgb '#808080'
set tics out nomirror scale 0.6 textcolor rgb '#000000'
set key noautotitle noopaque
set multiplot
set xrange [-20:1020]
set xtics 200
set format x ''
$s_1_1_1 << EOD
0 12.5824988
50 7.50373882
100 2.64898083
150 0.645805795
200 -0.0908687157
250 -1.05731067
300 -1.07081113
350 -1.53972826
400 -2.12101172
450 -2.35381722
500 -2.28030692
550 -2.0904459
600 -1.85753387
650 -1.63760595
700 -1.43561674
750 -1.2645294
800 -1.1201172
850 -0.998968367
900 -0.898406355
950 -0.815725445
1000 -0.748220379
EOD
$s_1_1_2 << EOD
0 9.89225564
50 1.71803126
100 5.37192192
150 1.28804515
200 -0.808892676
250 -1.94699889
300 -1.96742418
350 -1.89703279
400 -1.84628856
450 -1.59505671
500 -1.32395348
550 -1.20021553
600 -1.06643442
650 -0.898172521
700 -0.752314737
750 -0.697337834
800 -0.605534644
850 -0.507275668
900 -0.434543984
950 -0.381804108
1000 -0.340973228
EOD
set lmargin at screen 0.2083
set rmargin at screen 0.9583
set bmargin at screen 0.7565
set tmargin at screen 0.958
set yrange [-3.54872249598:13.7774040562]
set ytics 5
set label 's_1' at screen 0.02, graph 0.5 center rotate
set label 'deflection (%)' at screen 0.059, graph 0.5 center rotate
set key at screen 0.9583, screen 0.979 right center horizontal Left reverse samplen 1.5 font ',9'
set arrow from graph 0, first 0 to graph 1, first 0 nohead back lw 0.5 lc rgb '#999999'
plot $s_1_1_1 with lines lw 1.8 dt 1 lc rgb '#0072B2' title 'hub.inertia 0.0002787 kg m^2', \
     $s_1_1_2 with lines lw 1.8 dt 2 lc rgb '#D55E00' title 'hub.inertia 0.027 kg m^2', \
     NaN notitle
unset object
unset arrow
unset label
unset key
$s_2_1_1 << EOD
0 -17.3186967
50 -17.0971917
100 -8.01776688
150 -6.86321053
200 -5.28609259
250 -5.28058971
300 -3.89532613
350 -2.890012
400 -2.03194376
450 -1.00787283
500 0
550 0.863462584
600 1.58074863
650 2.166889
700 2.64160707
750 3.02445897
800 3.33286707
850 3.58079956
900 3.77967766
950 3.9388375
1000 4.06588318
EOD
$s_2_1_2 << EOD
0 -68.12494
50 -66.8255345
100 -53.7746478
150 -31.043394
200 -7.17629514
250 2.446598
300 -3.30665586
350 2.69062844
400 5.45077238
450 -0.462802675
500 0
550 -1.19585011
600 -1.91557858
650 -4.6730196
700 -5.23764813
750 -4.80896233
800 -4.9850918
850 -5.51585547
900 -6.29901225
950 -6.47752976
1000 -6.38386448
EOD
set lmargin at screen 0.2083
set rmargin at screen 0.9583
set bmargin at screen 0.5323
set tmargin at screen 0.7339
set yrange [-74.0109969685:11.3368293741]
set ytics 20
set label 's_2' at screen 0.02, graph 0.5 center rotate
set label 'deflection (%)' at screen 0.059, graph 0.5 center rotate
set arrow from graph 0, first 0 to graph 1, first 0 nohead back lw 0.5 lc rgb '#999999'
plot $s_2_1_1 with lines lw 1.8 dt 1 lc rgb '#0072B2' title '', \
     $s_2_1_2 with lines lw 1.8 dt 2 lc rgb '#D55E00' title '', \
     NaN notitle
unset object
unset arrow
unset label
unset key
$s_1_2_1 << EOD
0 21.0948246
50 -11.1059443
100 3.23448206
150 0.120300493
200 -3.24694886
250 -4.27430727
300 -3.40935566
350 -2.0478314
400 -1.24822971
450 -0.950680253
500 -0.735777787
550 -0.518882612
600 -0.304209373
650 -0.0989619733
700 0.0898540796
750 0.258894495
800 0.407220823
850 0.535522052
900 0.645269901
950 0.738283064
1000 0.816477593
EOD
$s_1_2_2 << EOD
0 0.0392256265
50 0.0235981646
100 0.00722063904
150 0.00822303028
200 0.00206325811
250 0.00607681356
300 -0.0016605882
350 -0.00152560673
400 -0.00355239514
450 -0.00137751897
500 -0.00234615554
550 -0.00249029626
600 -0.0100726675
650 -0.00517007164
700 -0.00480269611
750 -0.012749965
800 -0.0111090195
850 -0.00781403263
900 -0.00668496057
950 -0.00702320418
1000 -0.00802835399
EOD
set lmargin at screen 0.2083
set rmargin at screen 0.9583
set bmargin at screen 0.3081
set tmargin at screen 0.5097
set yrange [-13.6820057622:23.6708860905]
set ytics 10
set label 's_1' at screen 0.02, graph 0.5 center rotate
set label 'displacement (%)' at screen 0.059, graph 0.5 center rotate
set arrow from graph 0, first 0 to graph 1, first 0 nohead back lw 0.5 lc rgb '#999999'
plot $s_1_2_1 with lines lw 1.8 dt 1 lc rgb '#0072B2' title '', \
     $s_1_2_2 with lines lw 1.8 dt 2 lc rgb '#D55E00' title '', \
     NaN notitle
unset object
unset arrow
unset label
unset key
$s_2_2_1 << EOD
0 -21.9864377
50 10.4478571
100 -3.98962145
150 -0.860222272
200 2.52687573
250 3.56101739
300 2.69143343
350 1.3217637
400 0.516878417
450 0.216841215
500 0
550 -0.218741877
600 -0.435156757
650 -0.642009822
700 -0.832264827
750 -1.00256922
800 -1.15198893
850 -1.28122515
900 -1.39176517
950 -1.48544429
1000 -1.56419475
EOD
$s_2_2_2 << EOD
0 -0.833735884
50 13.2843611
100 -0.316590531
150 -8.22302762
200 -13.7646965
250 -6.19596682
300 -8.82921596
350 -0.311711482
400 -0.735231515
450 -4.2558737
500 0
550 0.213073123
600 0.439886842
650 -0.987432481
700 -0.0719507201
750 0.622166802
800 1.35536276
850 1.45937564
900 1.07973311
950 1.21088628
1000 1.49582921
EOD
set lmargin at screen 0.2083
set rmargin at screen 0.9583
set bmargin at screen 0.08398
set tmargin at screen 0.2855
set yrange [-24.808101575:16.10602504]
set ytics 10
set label 's_2' at screen 0.02, graph 0.5 center rotate
set label 'displacement (%)' at screen 0.059, graph 0.5 center rotate
set format x '%h'
set xlabel 'stop.spring.damping.coefficient (N s/m)'
set arrow from graph 0, first 0 to graph 1, first 0 nohead back lw 0.5 lc rgb '#999999'
plot $s_2_2_1 with lines lw 1.8 dt 1 lc rgb '#0072B2' title '', \
     $s_2_2_2 with lines lw 1.8 dt 2 lc rgb '#D55E00' title '', \
     NaN notitle
unset object
unset arrow
unset label
unset key
unset multiplot
