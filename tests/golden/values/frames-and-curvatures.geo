// Derivatives, frames, curvature and torsion in space.
// Expected values: computed with 40 digits from the definitions, with mpmath, by nothing of this program.
geo 1
curve quintic = nurbs(
    [
        (-1, 5, 7),
        (8, 6, 7),
        (-2, 7, -1),
        (8, -3, 5),
        (-5, 4, -6),
        (3, 5, 1),
        (-7, -2, 4),
        (-7, -3, 0),
        (-6, -5, 2),
    ],
    weights = [2, 3, 2, 5, 2, 1, 5, 5, 2],
    degree = 5,
    knots = [0, 0, 0, 0, 0, 0, 1, 1, 3, 4, 4, 4, 4, 4, 4],
)
check quintic(0) ~= (-1, 5, 7) within 7e-12
check derivative(quintic, 0) ~= (67.5, 7.5, 0) within 6.7e-11
check derivative(quintic, 0, order = 2) ~= (-897.5, -57.5, -160) within 9e-10
check derivative(quintic, 0, order = 3) ~= (13801.25, 471.25, 2220) within 1.4e-8
check tangent(quintic, 0) ~= (0.9938837346736189, 0.11043152607484654, 0) within 1e-12
check normal(quintic, 0)
    ~= (-0.028015859758384531, 0.25214273782546078, -0.96728442113159224) within 1e-12
check binormal(quintic, 0)
    ~= (-0.10681869477398627, 0.96136825296587646, 0.2536944000882174) within 1e-12
check curvature(quintic, 0) ~= 0.035861579206339486 within 1e-12
check center_of_curvature(quintic, 0)
    ~= (-1.7812221429844892, 12.030999286860403, -19.972722410411838) within 2e-10
check torsion(quintic, 0) ~= -0.040767813632851964 within 1e-11
check quintic(0.25) ~= (3.6540511621276834, 5.4117979281810324, 4.7376538030563029) within 5.4e-12
check derivative(quintic, 0.25)
    ~= (-1.3638462862639039, -4.1744761087086051, -12.066955295616593) within 1.2e-11
check derivative(quintic, 0.25, order = 2)
    ~= (-45.685730500051497, -47.498641782724873, 8.8709208725311089) within 4.7e-11
check derivative(quintic, 0.25, order = 3)
    ~= (762.1086782200792, 37.89292426165481, 318.78343980866029) within 7.6e-10
check tangent(quintic, 0.25)
    ~= (-0.10620820693556267, -0.32508327871451579, -0.93970244156315415) within 1e-12
check normal(quintic, 0.25)
    ~= (-0.67899226865775908, -0.66669802275953157, 0.30738127065831554) within 1e-12
check binormal(quintic, 0.25)
    ~= (-0.72642227105349834, 0.67069710626239589, -0.14992023135229688) within 1e-12
check curvature(quintic, 0.25) ~= 0.39669594166106331 within 1e-12
check center_of_curvature(quintic, 0.25)
    ~= (1.9424322687892446, 3.7311706448065082, 5.5125073832851166) within 5.5e-11
check torsion(quintic, 0.25) ~= -0.68570171832513608 within 1e-11
check quintic(0.99) ~= (4.9149441339033264, -0.50337024251634832, 2.8203465476375834) within 4.9e-12
check derivative(quintic, 0.99)
    ~= (0.9587255948811962, -2.4670212322528844, -0.30207868709754954) within 2.5e-12
check derivative(quintic, 0.99, order = 2)
    ~= (-18.037469645077856, 16.500783947606628, -11.97060675834579) within 1.8e-11
check derivative(quintic, 0.99, order = 3)
    ~= (52.684317831859895, -53.767376752941296, 32.633432337126101) within 5.4e-11
check tangent(quintic, 0.99)
    ~= (0.35988948382360633, -0.92607833002246009, -0.11339526487463973) within 1e-12
check normal(quintic, 0.99)
    ~= (-0.59377193442316721, -0.13359238326337655, -0.79346579322953874) within 1e-12
check binormal(quintic, 0.99)
    ~= (0.71966273303857288, 0.35289092053610931, -0.59795781530023434) within 1e-12
check curvature(quintic, 0.99) ~= 2.536993916108236 within 2.5e-12
check center_of_curvature(quintic, 0.99)
    ~= (4.6808986635326221, -0.55602798931469621, 2.5075882914227951) within 4.7e-11
check torsion(quintic, 0.99) ~= -0.011936490121562161 within 1e-11
check quintic(1) ~= (4.9236387782204515, -0.52722443559096946, 2.8167330677290837) within 4.9e-12
check derivative(quintic, 1)
    ~= (0.78117807653846764, -2.3047253218202886, -0.41999333343915176) within 2.3e-12
check derivative(quintic, 1, order = 2)
    ~= (-17.452481466334785, 15.956005504497462, -11.596150595472114) within 1.7e-11
check derivative(quintic, 1, order = 3)
    ~= (64.416699884453983, -55.203264825756788, 42.337265200868588) within 6.4e-11
check tangent(quintic, 1)
    ~= (0.31633144400677714, -0.93327899359512426, -0.17007274222126025) within 1e-12
check normal(quintic, 1)
    ~= (-0.61789159891228181, -0.066666157458008894, -0.78343193414833929) within 1e-12
check binormal(quintic, 1)
    ~= (0.71982247084000586, 0.35291067363265734, -0.59775385143881167) within 1e-12
check curvature(quintic, 1) ~= 3.0835685161107105 within 3.1e-12
check center_of_curvature(quintic, 1)
    ~= (4.7232567871331818, -0.5488442430023172, 2.562666414092187) within 4.7e-11
check torsion(quintic, 1) ~= 0.034012918986880448 within 1e-11
check quintic(2.5) ~= (-3.2704298260920142, 0.24853137904961321, 1.1874018495899494) within 3.3e-12
check derivative(quintic, 2.5)
    ~= (-7.2693135969367771, -2.8820399337347437, 2.8140172981291979) within 7.3e-12
check derivative(quintic, 2.5, order = 2)
    ~= (8.0854784947247097, -5.3429230446946472, 0.71788029935663665) within 8.1e-12
check derivative(quintic, 2.5, order = 3)
    ~= (14.864835648815143, 26.587614823104872, -34.667837550176434) within 3.5e-11
check tangent(quintic, 2.5)
    ~= (-0.8746930883131611, -0.34678658124511037, 0.33860163662556775) within 1e-12
check normal(quintic, 2.5)
    ~= (0.44718601141062789, -0.84684894639460236, 0.28787416207260713) within 1e-12
check binormal(quintic, 2.5)
    ~= (0.18691354272988981, 0.40321945520855062, 0.89581102833436991) within 1e-12
check curvature(quintic, 2.5) ~= 0.12085262194713678 within 1e-12
check center_of_curvature(quintic, 2.5)
    ~= (0.4298292514994964, -6.7587551220660192, 3.5694284654339046) within 6.8e-11
check torsion(quintic, 2.5) ~= -0.25308993983139359 within 1e-11
check quintic(3) ~= (-5.8342210386151798, -1.3746116289391922, 2.143364403018198) within 5.8e-12
check derivative(quintic, 3)
    ~= (-3.2017407770553598, -2.9100184810547026, 0.33568498401007563) within 3.2e-12
check derivative(quintic, 3, order = 2)
    ~= (6.1883633702087736, 2.8839792352472377, -7.5776526865271028) within 7.6e-12
check derivative(quintic, 3, order = 3)
    ~= (-9.3374791002220634, 2.193274240432019, -1.7396689636200058) within 9.3e-12
check tangent(quintic, 3)
    ~= (-0.73779809515728278, -0.67057461602786279, 0.077354089234955706) within 1e-12
check normal(quintic, 3)
    ~= (0.13091164717355771, -0.25456305426143655, -0.95815436754178335) within 1e-12
check binormal(quintic, 3)
    ~= (0.66220549032501312, -0.69679791600160035, 0.27560216406849141) within 1e-12
check curvature(quintic, 3) ~= 0.38957738333545296 within 1e-12
check center_of_curvature(quintic, 3)
    ~= (-5.4981860099573848, -2.0280454912490076, -0.31610683049729193) within 5.5e-11
check torsion(quintic, 3) ~= -0.25727655584178104 within 1e-11
check quintic(3.9) ~= (-6.6306011001064792, -3.6863768634821959, 0.90709394513668467) within 6.6e-12
check derivative(quintic, 3.9)
    ~= (3.0573217089085975, -7.0094272919193779, 3.6158743838803447) within 7e-12
check derivative(quintic, 3.9, order = 2)
    ~= (34.457992500335575, -62.958833776461778, 76.00373736247986) within 7.6e-11
check derivative(quintic, 3.9, order = 3)
    ~= (473.51735107539334, -928.73905317973194, 1097.9649980962435) within 1.1e-9
check tangent(quintic, 3.9)
    ~= (0.3614304045607693, -0.82864035357342178, 0.42746137496708772) within 1e-12
check normal(quintic, 3.9)
    ~= (-0.016584300012255537, 0.45266744213074196, 0.89152518070322325) within 1e-12
check binormal(quintic, 3.9)
    ~= (-0.93225158817356924, -0.32931345442378438, 0.14986535651487956) within 1e-12
check curvature(quintic, 3.9) ~= 0.54068897911074294 within 1e-12
check center_of_curvature(quintic, 3.9)
    ~= (-6.6612736321035828, -2.8491720015017791, 2.5559627313462565) within 6.7e-11
check torsion(quintic, 3.9) ~= 0.088478931567787806 within 1e-11
check quintic(4) ~= (-6, -5, 2) within 6e-12
check derivative(quintic, 4) ~= (12.5, -25, 25) within 2.5e-11
check derivative(quintic, 4, order = 2)
    ~= (237.5, -458.33333333333333, 541.66666666666667) within 5.4e-10
check derivative(quintic, 4, order = 3)
    ~= (6572.0833333333333, -12779.166666666667, 15040.833333333333) within 1.5e-8
check tangent(quintic, 4)
    ~= (0.33333333333333333, -0.66666666666666667, 0.66666666666666667) within 1e-12
check normal(quintic, 4)
    ~= (-0.18490006540840971, 0.64715022892943398, 0.73960026163363883) within 1e-12
check binormal(quintic, 4)
    ~= (-0.92450032704204854, -0.36980013081681941, 0.092450032704204854) within 1e-12
check curvature(quintic, 4) ~= 0.042732459561054688 within 1e-12
check center_of_curvature(quintic, 4)
    ~= (-10.326923076923077, 10.144230769230769, 19.307692307692308) within 1.9e-10
check torsion(quintic, 4) ~= 0.017914529914529915 within 1e-11
curve spatial = clamped([
    (-2, -4, 4),
    (7, 3, 1),
    (4, -3, 2),
    (1, -7, 2),
    (-9, 1, 8),
    (5, 5, -9),
    (3, 1, 7),
])
check spatial(0) ~= (-2, -4, 4) within 4e-12
check derivative(spatial, 0) ~= (27, 21, -9) within 2.7e-11
check derivative(spatial, 0, order = 2) ~= (-63, -60, 21) within 6.3e-11
check tangent(spatial, 0)
    ~= (0.76337003671197384, 0.59373225077597965, -0.25445667890399128) within 1e-12
check normal(spatial, 0)
    ~= (0.56326386982511111, -0.80466267117873015, -0.18775462327503704) within 1e-12
check binormal(spatial, 0) ~= (-0.31622776601683793, 0, -0.9486832980505138) within 1e-12
check curvature(spatial, 0) ~= 0.0070753712094053011 within 1e-12
check center_of_curvature(spatial, 0)
    ~= (77.609090909090909, -117.72727272727273, -22.536363636363636) within 1.2e-9
check torsion(spatial, 0) ~= 0.0030303030303030303 within 1e-11
check spatial(0.5) ~= (4.96875, 0.35416666666666667, 1.65625) within 5e-12
check derivative(spatial, 0.5) ~= (3.5625, -0.875, -1.3125) within 3.6e-12
check derivative(spatial, 0.5, order = 2) ~= (-30.75, -27.5, 9.75) within 3.1e-11
check tangent(spatial, 0.5)
    ~= (0.91437313474420575, -0.22458287520033124, -0.33687431280049686) within 1e-12
check normal(spatial, 0.5)
    ~= (-0.2255714009970616, -0.97353299043939788, 0.036756762348526615) within 1e-12
check binormal(spatial, 0.5)
    ~= (-0.33621319651417222, 0.042379814686660364, -0.94083188604386009) within 1e-12
check curvature(spatial, 0.5) ~= 2.2442396294812539 within 2.2e-12
check center_of_curvature(spatial, 0.5)
    ~= (4.8682387185691479, -0.079625241136167099, 1.6726282698895763) within 4.9e-11
check torsion(spatial, 0.5) ~= 0.016858910397126322 within 1e-11
check spatial(1) ~= (4.25, -2.1666666666666667, 1.75) within 4.2e-12
check derivative(spatial, 1) ~= (-3.75, -6.5, 0.75) within 6.5e-12
check derivative(spatial, 1, order = 2) ~= (1.5, 5, -1.5) within 5e-12
check tangent(spatial, 1)
    ~= (-0.4972451580988469, -0.86189160737133463, 0.099449031619769381) within 1e-12
check normal(spatial, 1)
    ~= (-0.70032290465187531, 0.33106173674452287, -0.63241280480684497) within 1e-12
check binormal(spatial, 1)
    ~= (0.51214751973158389, -0.38411063979868792, -0.76822127959737584) within 1e-12
check curvature(spatial, 1) ~= 0.027313292904704507 within 1e-12
check center_of_curvature(spatial, 1)
    ~= (-21.390368852459016, 9.9542349726775956, -21.404030054644809) within 2.1e-10
check torsion(spatial, 1) ~= -1.092896174863388 within 1.1e-11
check spatial(1.7) ~= (1.5065833333333333, -5.0915, 2.33625) within 5.1e-12
check derivative(spatial, 1.7) ~= (-4.7825, -1.285, 1.5375) within 4.8e-12
check derivative(spatial, 1.7, order = 2) ~= (-4.45, 9.9, 3.75) within 9.9e-12
check tangent(spatial, 1.7)
    ~= (-0.92231712360591629, -0.24781547388052325, 0.29651073236677392) within 1e-12
check normal(spatial, 1.7)
    ~= (-0.1706181059941172, 0.9496073141515103, 0.26293613448313835) within 1e-12
check binormal(spatial, 1.7)
    ~= (-0.3467284029471614, 0.19192039968519899, -0.9181208933328902) within 1e-12
check curvature(spatial, 1.7) ~= 0.41455692778776491 within 1e-12
check center_of_curvature(spatial, 1.7)
    ~= (1.0950159596927552, -2.8008439995829285, 2.9705082088454452) within 3e-11
check torsion(spatial, 1.7) ~= -0.04490292820432829 within 1e-11
check spatial(2) ~= (-0.16666666666666667, -5, 3) within 5e-12
check derivative(spatial, 2) ~= (-6.5, 2, 3) within 6.5e-12
check derivative(spatial, 2, order = 2) ~= (-7, 12, 6) within 1.2e-11
check tangent(spatial, 2)
    ~= (-0.87447463219520621, 0.26906911759852499, 0.40360367639778748) within 1e-12
check normal(spatial, 2)
    ~= (0.34641288062084123, 0.92884332825807979, 0.13133235583976948) within 1e-12
check binormal(spatial, 2)
    ~= (-0.33954710098457566, 0.25466032573843175, -0.90545893595886844) within 1e-12
check curvature(spatial, 2) ~= 0.17211264995094454 within 1e-12
check center_of_curvature(spatial, 2)
    ~= (1.8460435014678409, 0.3967173738991193, 3.7630604483586869) within 3.8e-11
check torsion(spatial, 2) ~= 0.24739791833466773 within 1e-11
check spatial(3.999) ~= (3.0059730141666667, 1.0119820056666667, 6.95207347025) within 7e-12
check derivative(spatial, 3.999) ~= (-5.9460425, -11.964017, 47.85308925) within 4.8e-11
check derivative(spatial, 3.999, order = 2) ~= (-53.915, -35.966, 146.8215) within 1.5e-10
check tangent(spatial, 3.999)
    ~= (-0.11967935730709155, -0.24080653062454859, 0.96316616751375245) within 1e-12
check normal(spatial, 3.999)
    ~= (-0.99260801086719725, 0.048716062273520532, -0.1111579148726194) within 1e-12
check binormal(spatial, 3.999)
    ~= (-0.020154111164413685, -0.969349761481959, -0.24485679839049118) within 1e-12
check curvature(spatial, 3.999) ~= 0.01435902014032445 within 1e-12
check center_of_curvature(spatial, 3.999)
    ~= (-66.121864482185553, 4.404696954001558, -0.78925663349813219) within 6.6e-10
check torsion(spatial, 3.999) ~= -0.0051312431698974061 within 1e-11
check spatial(4) ~= (3, 1, 7) within 7e-12
check derivative(spatial, 4) ~= (-6, -12, 48) within 4.8e-11
check derivative(spatial, 4, order = 2) ~= (-54, -36, 147) within 1.5e-10
check tangent(spatial, 4)
    ~= (-0.1203858530857692, -0.2407717061715384, 0.96308682468615361) within 1e-12
check normal(spatial, 4)
    ~= (-0.99251740368170098, 0.049134524934737672, -0.1117810442265282) within 1e-12
check binormal(spatial, 4)
    ~= (-0.020407100865801756, -0.9693372911255834, -0.24488521038962107) within 1e-12
check curvature(spatial, 4) ~= 0.014249308937142371 within 1e-12
check center_of_curvature(spatial, 4)
    ~= (-66.653722019781364, 4.448204060385216, -0.84466423737636648) within 6.7e-10
check torsion(spatial, 4) ~= -0.0051130776794493609 within 1e-11
curve conical = parametric(t => (t*cos(t), t*sin(t), 2*t), 0..9)
check curvature(conical, 0) ~= 0.4 within 1e-12
check torsion(conical, 0) ~= 0.6 within 1e-12
check binormal(conical, 0) ~= (-0.89442719099991588, 0, 0.44721359549995794) within 1e-12
check curvature(conical, 0.5) ~= 0.39047065976947042 within 1e-12
check torsion(conical, 0.5) ~= 0.56657223796033994 within 1e-12
check binormal(conical, 0.5)
    ~= (-0.64527512123614468, -0.59511197395090372, 0.47902166587111452) within 1e-12
check curvature(conical, 3) ~= 0.25109091427274046 within 1e-12
check torsion(conical, 3) ~= 0.17341040462427746 within 1e-12
check binormal(conical, 3)
    ~= (0.36544587613361684, 0.40868979226182552, 0.83631451339667607) within 1e-12
check curvature(conical, 9) ~= 0.10660840247600642 within 1e-12
check torsion(conical, 9) ~= 0.02406971918660949 within 1e-12
check binormal(conical, 9)
    ~= (0.130112855606491, 0.17350339888151246, 0.97620039714317224) within 1e-12
