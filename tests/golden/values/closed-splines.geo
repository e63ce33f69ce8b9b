// Periodic splines of several degrees, and the closed cubic through points.
// Expected values: computed with 40 digits from the definitions, with mpmath, by nothing of this program.
geo 1
let ring = [(-8, -6), (7, 5), (8, -9), (-7, 5), (1, 7), (7, -3)]
curve coons = coons_bspline(ring, closed = true)
check coons.domain.start == 0 and coons.domain.end == 6 and coons.closed
check coons(0) ~= (4.6666666666666667, 0.83333333333333333, 0) within 4.7e-12
check derivative(coons, 0) ~= (8, -1.5, 0) within 8e-12
check derivative(coons, 0, order = 2) ~= (-14, -25, 0) within 2.5e-11
check tangent(coons, 0) ~= (0.9828721869343219, -0.18428853505018536, 0) within 1e-12
check normal(coons, 0) ~= (-0.18428853505018536, -0.9828721869343219, 0) within 1e-12
check binormal(coons, 0) ~= (0, 0, -1) within 1e-12
check curvature(coons, 0) ~= 0.40983915719336819 within 1e-12
check center_of_curvature(coons, 0) ~= (4.2170060331825038, -1.5648567119155354, 0) within 4.2e-11
check coons(0.3) ~= (6.4276666666666667, -0.50316666666666667, 0) within 6.4e-12
check derivative(coons, 0.3) ~= (3.71, -6.615, 0) within 6.6e-12
check derivative(coons, 0.3, order = 2) ~= (-14.6, -9.1, 0) within 1.5e-11
check tangent(coons, 0.3) ~= (0.4891653585916369, -0.87219106390395636, 0) within 1e-12
check normal(coons, 0.3) ~= (-0.87219106390395636, -0.4891653585916369, 0) within 1e-12
check binormal(coons, 0.3) ~= (0, 0, -1) within 1e-12
check curvature(coons, 0.3) ~= 0.29876042555967024 within 1e-12
check center_of_curvature(coons, 0.3) ~= (3.508300548245614, -2.1404831140350877, 0) within 3.5e-11
check coons(1.5) ~= (0.64583333333333333, -1.6666666666666667, 0) within 1.7e-12
check derivative(coons, 1.5) ~= (-10.125, 9, 0) within 1e-11
check derivative(coons, 1.5, order = 2) ~= (3.5, 8, 0) within 8e-12
check tangent(coons, 1.5) ~= (-0.74740931868365972, 0.66436383882991975, 0) within 1e-12
check normal(coons, 1.5) ~= (0.66436383882991975, 0.74740931868365972, 0) within 1e-12
check binormal(coons, 1.5) ~= (0, 0, -1) within 1e-12
check curvature(coons, 1.5) ~= 0.045252539043332124 within 1e-12
check center_of_curvature(coons, 1.5) ~= (15.327083333333333, 14.849739583333333, 0) within 1.5e-10
check coons(3.7) ~= (3.9905, 0.34616666666666667, 0) within 4e-12
check derivative(coons, 3.7) ~= (0.945, -7.745, 0) within 7.7e-12
check derivative(coons, 3.7, order = 2) ~= (-15.3, 1.3, 0) within 1.5e-11
check tangent(coons, 3.7) ~= (0.12111597844625781, -0.99263836303308649, 0) within 1e-12
check normal(coons, 3.7) ~= (-0.99263836303308649, -0.12111597844625781, 0) within 1e-12
check binormal(coons, 3.7) ~= (0, 0, -1) within 1e-12
check curvature(coons, 3.7) ~= 0.24688563747403355 within 1e-12
check center_of_curvature(coons, 3.7)
    ~= (-0.030140379039822632, -0.14440856357124584, 0) within 1e-11
check coons(5.9) ~= (3.804, 0.86483333333333333, 0) within 3.8e-12
check derivative(coons, 5.9) ~= (9.18, 0.805, 0) within 9.2e-12
check derivative(coons, 5.9, order = 2) ~= (-9.6, -21.1, 0) within 2.1e-11
check tangent(coons, 5.9) ~= (0.99617720940523572, 0.087355408885753241, 0) within 1e-12
check normal(coons, 5.9) ~= (0.087355408885753241, -0.99617720940523572, 0) within 1e-12
check binormal(coons, 5.9) ~= (0, 0, -1) within 1e-12
check curvature(coons, 5.9) ~= 0.23764279551294335 within 1e-12
check center_of_curvature(coons, 5.9) ~= (4.171591235817605, -3.327076660214013, 0) within 4.2e-11
check length(coons) ~= 49.913518522440004 within 5e-9
curve periodic_2 = bspline(ring, degree = 2, closed = true)
check periodic_2.closed
check length(periodic_2) ~= 60.721786129021123 within 6.1e-9
check periodic_2(0) ~= (-0.5, -0.5, 0) within 1e-12
check derivative(periodic_2, 0) ~= (90, 66, 0) within 9e-11
check derivative(periodic_2, 0, order = 2) ~= (-504, -900, 0) within 9e-10
check tangent(periodic_2, 0) ~= (0.80640499585570554, 0.59136366362751739, 0) within 1e-12
check normal(periodic_2, 0) ~= (0.59136366362751739, -0.80640499585570554, 0) within 1e-12
check binormal(periodic_2, 0) ~= (0, 0, -1) within 1e-12
check curvature(periodic_2, 0) ~= 0.034338247415050274 within 1e-12
check center_of_curvature(periodic_2, 0)
    ~= (16.721719457013575, -23.984162895927602, 0) within 2.4e-10
check periodic_2(0.05) ~= (3.37, 1.675, 0) within 3.4e-12
check derivative(periodic_2, 0.05) ~= (64.8, 21, 0) within 6.5e-11
check derivative(periodic_2, 0.05, order = 2) ~= (-504, -900, 0) within 9e-10
check tangent(periodic_2, 0.05) ~= (0.95129265522328072, 0.30828928641495208, 0) within 1e-12
check normal(periodic_2, 0.05) ~= (0.30828928641495208, -0.95129265522328072, 0) within 1e-12
check binormal(periodic_2, 0.05) ~= (0, 0, -1) within 1e-12
check curvature(periodic_2, 0.05) ~= 0.15103007503121025 within 1e-12
check center_of_curvature(periodic_2, 0.05)
    ~= (5.4112443438914027, -4.6236968325791855, 0) within 5.4e-11
check periodic_2(0.3) ~= (3.18, -4.24, 0) within 4.2e-12
check derivative(periodic_2, 0.3) ~= (-70.8, 50.4, 0) within 7.1e-11
check derivative(periodic_2, 0.3, order = 2) ~= (-576, 1008, 0) within 1e-9
check tangent(periodic_2, 0.3) ~= (-0.81466538833288426, 0.57993129338951083, 0) within 1e-12
check normal(periodic_2, 0.3) ~= (0.57993129338951083, 0.81466538833288426, 0) within 1e-12
check binormal(periodic_2, 0.3) ~= (0, 0, -1) within 1e-12
check curvature(periodic_2, 0.3) ~= 0.064498237269249695 within 1e-12
check center_of_curvature(periodic_2, 0.3)
    ~= (12.171428571428571, 8.3908163265306122, 0) within 1.2e-10
check periodic_2(0.55) ~= (-0.69, 6.06, 0) within 6.1e-12
check derivative(periodic_2, 0.55) ~= (44.4, -9.6, 0) within 4.4e-11
check derivative(periodic_2, 0.55, order = 2) ~= (-72, -432, 0) within 4.3e-10
check tangent(periodic_2, 0.55) ~= (0.97741416543986726, -0.21133279252753887, 0) within 1e-12
check normal(periodic_2, 0.55) ~= (-0.21133279252753887, -0.97741416543986726, 0) within 1e-12
check binormal(periodic_2, 0.55) ~= (0, 0, -1) within 1e-12
check curvature(periodic_2, 0.55) ~= 0.21199643353687168 within 1e-12
check center_of_curvature(periodic_2, 0.55)
    ~= (-1.6868695652173913, 1.4494782608695652, 0) within 1.7e-11
check periodic_2(0.97) ~= (-2.714, -2.2532, 0) within 2.7e-12
check derivative(periodic_2, 0.97) ~= (57.6, 50.88, 0) within 5.8e-11
check derivative(periodic_2, 0.97, order = 2) ~= (1080, 504, 0) within 1.1e-9
check tangent(periodic_2, 0.97) ~= (0.74947321178188551, 0.6620346704073322, 0) within 1e-12
check normal(periodic_2, 0.97) ~= (0.6620346704073322, -0.74947321178188551, 0) within 1e-12
check binormal(periodic_2, 0.97) ~= (0, 0, -1) within 1e-12
check curvature(periodic_2, 0.97) ~= 0.057099971398092337 within 1e-12
check center_of_curvature(periodic_2, 0.97) ~= (8.8803082666666667, -15.378832, 0) within 1.5e-10
curve periodic_4 = bspline(ring, degree = 4, closed = true)
check periodic_4.closed
check length(periodic_4) ~= 41.226088618354353 within 4.1e-9
check periodic_4(0) ~= (6.25, -1.875, 0) within 6.2e-12
check derivative(periodic_4, 0) ~= (4, -31, 0) within 3.1e-11
check derivative(periodic_4, 0, order = 2) ~= (-540, 54, 0) within 5.4e-10
check tangent(periodic_4, 0) ~= (0.12797133763019679, -0.99177786663402515, 0) within 1e-12
check normal(periodic_4, 0) ~= (-0.99177786663402515, -0.12797133763019679, 0) within 1e-12
check binormal(periodic_4, 0) ~= (0, 0, -1) within 1e-12
check curvature(periodic_4, 0) ~= 0.54109477558888736 within 1e-12
check center_of_curvature(periodic_4, 0)
    ~= (4.4170902929072864, -2.1115044783345437, 0) within 4.4e-11
check periodic_4(0.05) ~= (5.7798375, -3.1503875, 0) within 5.8e-12
check derivative(periodic_4, 0.05) ~= (-22.433, -16.501, 0) within 2.2e-11
check derivative(periodic_4, 0.05, order = 2) ~= (-495.18, 475.74, 0) within 5e-10
check tangent(periodic_4, 0.05) ~= (-0.80554565218119009, -0.59253371402138892, 0) within 1e-12
check normal(periodic_4, 0.05) ~= (-0.59253371402138892, 0.80554565218119009, 0) within 1e-12
check binormal(periodic_4, 0.05) ~= (0, 0, -1) within 1e-12
check curvature(periodic_4, 0.05) ~= 0.8724971123375039 within 1e-12
check center_of_curvature(periodic_4, 0.05)
    ~= (5.1007135170747913, -2.2271229518537539, 0) within 5.1e-11
check periodic_4(0.3) ~= (-2.6526, 4.3626666666666667, 0) within 4.4e-12
check derivative(periodic_4, 0.3) ~= (7.912, 26.08, 0) within 2.6e-11
check derivative(periodic_4, 0.3, order = 2) ~= (511.92, -403.2, 0) within 5.1e-10
check tangent(periodic_4, 0.3) ~= (0.29030881872144134, 0.95693301216572172, 0) within 1e-12
check normal(periodic_4, 0.3) ~= (0.95693301216572172, -0.29030881872144134, 0) within 1e-12
check binormal(periodic_4, 0.3) ~= (0, 0, -1) within 1e-12
check curvature(periodic_4, 0.3) ~= 0.81711541135666169 within 1e-12
check center_of_curvature(periodic_4, 0.3)
    ~= (-1.4814887972668145, 4.0073817036288996, 0) within 4e-11
check periodic_4(0.55) ~= (3.3122916666666667, -0.28938333333333333, 0) within 3.3e-12
check derivative(periodic_4, 0.55) ~= (-6.94, -40.694, 0) within 4.1e-11
check derivative(periodic_4, 0.55, order = 2) ~= (-505.8, 95.76, 0) within 5.1e-10
check tangent(periodic_4, 0.55) ~= (-0.16811389857831982, -0.98576757762912775, 0) within 1e-12
check normal(periodic_4, 0.55) ~= (-0.98576757762912775, 0.16811389857831982, 0) within 1e-12
check binormal(periodic_4, 0.55) ~= (0, 0, -1) within 1e-12
check curvature(periodic_4, 0.55) ~= 0.30202460232129317 within 1e-12
check center_of_curvature(periodic_4, 0.55)
    ~= (0.048426504515173563, 0.26723985989739754, 0) within 1e-11
check periodic_4(0.97) ~= (5.89078108, -0.96819192, 0) within 5.9e-12
check derivative(periodic_4, 0.97) ~= (19.760656, -28.004944, 0) within 2.8e-11
check derivative(periodic_4, 0.97, order = 2) ~= (-502.5456, -235.7856, 0) within 5e-10
check tangent(periodic_4, 0.97) ~= (0.57653636562590788, -0.81707148959614878, 0) within 1e-12
check normal(periodic_4, 0.97) ~= (-0.81707148959614878, -0.57653636562590788, 0) within 1e-12
check binormal(periodic_4, 0.97) ~= (0, 0, -1) within 1e-12
check curvature(periodic_4, 0.97) ~= 0.46524776317152235 within 1e-12
check center_of_curvature(periodic_4, 0.97)
    ~= (4.1345738410305995, -2.207394794820393, 0) within 4.1e-11
curve periodic_5 = bspline(ring, degree = 5, closed = true)
check periodic_5.closed
check length(periodic_5) ~= 34.346055028453039 within 3.4e-9
check periodic_5(0) ~= (4.3416666666666667, -2.775, 0) within 4.3e-12
check derivative(periodic_5, 0) ~= (-32.75, 3.25, 0) within 3.3e-11
check derivative(periodic_5, 0, order = 2) ~= (-330, 450, 0) within 4.5e-10
check tangent(periodic_5, 0) ~= (-0.99511211661769737, 0.098751584091832563, 0) within 1e-12
check normal(periodic_5, 0) ~= (0.098751584091832563, 0.99511211661769737, 0) within 1e-12
check binormal(periodic_5, 0) ~= (0, 0, -1) within 1e-12
check curvature(periodic_5, 0) ~= 0.38334673258179718 within 1e-12
check center_of_curvature(periodic_5, 0)
    ~= (4.5992704903036956, -0.17914608488840102, 0) within 4.6e-11
check periodic_5(0.05) ~= (2.3866279166666667, -2.04944425, 0) within 2.4e-12
check derivative(periodic_5, 0.05) ~= (-43.360625, 25.263325, 0) within 4.3e-11
check derivative(periodic_5, 0.05, order = 2) ~= (-80.79, 391.086, 0) within 3.9e-10
check tangent(periodic_5, 0.05) ~= (-0.86404220234391942, 0.50341938040630637, 0) within 1e-12
check normal(periodic_5, 0.05) ~= (0.50341938040630637, 0.86404220234391942, 0) within 1e-12
check binormal(periodic_5, 0.05) ~= (0, 0, -1) within 1e-12
check curvature(periodic_5, 0.05) ~= 0.11802969724517076 within 1e-12
check center_of_curvature(periodic_5, 0.05)
    ~= (6.6518204246217271, 5.2711049211898133, 0) within 6.7e-11
check periodic_5(0.3) ~= (-0.47378666666666667, 4.6119893333333333, 0) within 4.6e-12
check derivative(periodic_5, 0.3) ~= (29.54, -7.6704, 0) within 3e-11
check derivative(periodic_5, 0.3, order = 2) ~= (123.36, -371.712, 0) within 3.7e-10
check tangent(periodic_5, 0.3) ~= (0.96790225498364029, -0.25132692811870394, 0) within 1e-12
check normal(periodic_5, 0.3) ~= (-0.25132692811870394, -0.96790225498364029, 0) within 1e-12
check binormal(periodic_5, 0.3) ~= (0, 0, -1) within 1e-12
check curvature(periodic_5, 0.3) ~= 0.35297480326643169 within 1e-12
check center_of_curvature(periodic_5, 0.3)
    ~= (-1.1858117908197861, 1.8698608696960851, 0) within 1.9e-11
check periodic_5(0.55) ~= (1.0556170833333333, -2.6962385, 0) within 2.7e-12
check derivative(periodic_5, 0.55) ~= (-29.924125, -20.38285, 0) within 3e-11
check derivative(periodic_5, 0.55, order = 2) ~= (-76.53, 295.452, 0) within 3e-10
check tangent(periodic_5, 0.55) ~= (-0.8264838800693519, -0.56296038580481766, 0) within 1e-12
check normal(periodic_5, 0.55) ~= (-0.56296038580481766, 0.8264838800693519, 0) within 1e-12
check binormal(periodic_5, 0.55) ~= (0, 0, -1) within 1e-12
check curvature(periodic_5, 0.55) ~= 0.21913696143589209 within 1e-12
check center_of_curvature(periodic_5, 0.55)
    ~= (-1.5133716537378894, 1.0753017944981395, 0) within 1.5e-11
check periodic_5(0.97) ~= (5.1594795813066667, -2.6800945116, 0) within 5.2e-12
check derivative(periodic_5, 0.97) ~= (-21.29117444, -9.1243754, 0) within 2.1e-11
check derivative(periodic_5, 0.97, order = 2) ~= (-425.933808, 360.11592, 0) within 4.3e-10
check tangent(periodic_5, 0.97) ~= (-0.91915149547157574, -0.39390421217900918, 0) within 1e-12
check normal(periodic_5, 0.97) ~= (-0.39390421217900918, 0.91915149547157574, 0) within 1e-12
check binormal(periodic_5, 0.97) ~= (0, 0, -1) within 1e-12
check curvature(periodic_5, 0.97) ~= 0.92957070798924686 within 1e-12
check center_of_curvature(periodic_5, 0.97)
    ~= (4.7357310608406304, -1.6913031398712252, 0) within 4.7e-11
curve through = interpolate(ring, closed = true, parameters = "uniform")
check through((0 + 1/4)/6) ~= (-6.584375, -2.74375, 0) within 6.6e-12
check through((0 + 2/3)/6) ~= (0.6962962962962963, 3.4518518518518519, 0) within 3.5e-12
check through((1 + 1/4)/6) ~= (9.959375, 2.371875, 0) within 1e-11
check through((1 + 2/3)/6) ~= (10.822222222222222, -5.2814814814814815, 0) within 1.1e-11
check through((2 + 1/4)/6) ~= (4.090625, -7.853125, 0) within 7.9e-12
check through((2 + 2/3)/6) ~= (-3.2444444444444444, -0.95555555555555556, 0) within 3.2e-12
check through((3 + 1/4)/6) ~= (-7.2125, 7.665625, 0) within 7.7e-12
check through((3 + 2/3)/6) ~= (-3.6222222222222222, 8.5851851851851852, 0) within 8.6e-12
check through((4 + 1/4)/6) ~= (4.43125, 4.940625, 0) within 4.9e-12
check through((4 + 2/3)/6) ~= (7.9925925925925926, 0.61481481481481481, 0) within 8e-12
check through((5 + 1/4)/6) ~= (3.315625, -5.38125, 0) within 5.4e-12
check through((5 + 2/3)/6) ~= (-4.6444444444444444, -7.4148148148148148, 0) within 7.4e-12
