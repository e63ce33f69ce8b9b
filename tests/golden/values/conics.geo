// Conics by their middle weight, ellipses and arcs.
// Expected values: computed with 40 digits from the definitions, with mpmath, by nothing of this program.
geo 1
curve conic_0 = conic((0, 0, 1), (3, 5, 2), (7, -1, 0), 0.001)
check conic_kind(conic_0) == "ellipse"
check conic_0(0) ~= (0, 0, 1) within 1e-12
check derivative(conic_0, 0) ~= (0.006, 0.01, 0.002) within 1e-12
check derivative(conic_0, 0, order = 2) ~= (14.011976, -1.98004, -1.996008) within 1.4e-11
check tangent(conic_0, 0)
    ~= (0.50709255283710995, 0.84515425472851658, 0.16903085094570332) within 1e-12
check normal(conic_0, 0)
    ~= (0.85592098502182583, -0.47075654176200421, -0.21398024625545646) within 1e-12
check binormal(conic_0, 0)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_0, 0) ~= 95374.052616717736 within 9.5e-8
check center_of_curvature(conic_0, 0)
    ~= (8.9743589743589744e-6, -4.9358974358974359e-6, 0.99999775641025641) within 1e-11
check conic_0(0.2) ~= (0.41298212605832549, -0.056444026340545626, 0.94167450611476952) within 1e-12
check derivative(conic_0, 0.2)
    ~= (4.8487226198240837, -0.67859992176776531, -0.68897078149931547) within 4.8e-12
check derivative(conic_0, 0.2, order = 2)
    ~= (35.223160832492289, -5.0291933842509022, -5.0311730834862679) within 3.5e-11
check tangent(conic_0, 0.2)
    ~= (0.98068548307783505, -0.13725121939838801, -0.13934879279724264) within 1e-12
check normal(conic_0, 0.2)
    ~= (-0.16733072946707382, -0.95763225649050244, -0.23439472755359814) within 1e-12
check binormal(conic_0, 0.2)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_0, 0.2) ~= 0.0041513542421427694 within 1e-12
check center_of_curvature(conic_0, 0.2)
    ~= (-39.894522294644672, -230.73592851095285, -55.520557787656574) within 2.3e-9
check conic_0(0.5) ~= (3.4995004995004995, -0.49450549450549451, 0.5014985014985015) within 3.5e-12
check derivative(conic_0, 0.5)
    ~= (13.986013986013986, -1.998001998001998, -1.998001998001998) within 1.4e-11
check derivative(conic_0, 0.5, order = 2)
    ~= (0.0079840239680399521, -0.087824263648439473, -0.023952071904119856) within 1e-12
check tangent(conic_0, 0.5)
    ~= (0.98019605881960686, -0.14002800840280098, -0.14002800840280098) within 1e-12
check normal(conic_0, 0.5)
    ~= (-0.17017425192460682, -0.95723016707591335, -0.23398959639633438) within 1e-12
check binormal(conic_0, 0.5)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_0, 0.5) ~= 0.00043377750490586052 within 1e-12
check center_of_curvature(conic_0, 0.5)
    ~= (-388.80819180819181, -2207.2252747252747, -538.92157842157842) within 2.2e-8
check conic_0(0.9)
    ~= (6.9137750249945134, -0.98649077031871053, 0.012631373600916872) within 6.9e-12
check derivative(conic_0, 0.9)
    ~= (1.8827842669277107, -0.28188099285836413, -0.2723670262182759) within 1.9e-12
check derivative(conic_0, 0.9, order = 2)
    ~= (-23.968311522339707, 3.4420910972752149, 3.4287936068976573) within 2.4e-11
check tangent(conic_0, 0.9)
    ~= (0.97900911229986629, -0.14657232134342433, -0.14162525427983443) within 1e-12
check normal(conic_0, 0.9)
    ~= (-0.1768749495474629, -0.95624996235996572, -0.23302631119499488) within 1e-12
check binormal(conic_0, 0.9)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_0, 0.9) ~= 0.040258101133094313 within 1e-12
check center_of_curvature(conic_0, 0.9)
    ~= (2.5202506269433041, -24.739473038373998, -5.7756771813556106) within 2.5e-10
check length(conic_0) ~= 7.1414835105109045 within 7.1e-10
curve conic_1 = conic((0, 0, 1), (3, 5, 2), (7, -1, 0), 0.3)
check conic_kind(conic_1) == "ellipse"
check conic_1(0) ~= (0, 0, 1) within 1e-12
check derivative(conic_1, 0) ~= (1.8, 3, 0.6) within 3e-12
check derivative(conic_1, 0, order = 2) ~= (15.44, 0.4, -1.52) within 1.5e-11
check tangent(conic_1, 0)
    ~= (0.50709255283710995, 0.84515425472851658, 0.16903085094570332) within 1e-12
check normal(conic_1, 0)
    ~= (0.85592098502182583, -0.47075654176200421, -0.21398024625545646) within 1e-12
check binormal(conic_1, 0)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_1, 0) ~= 1.0597116957413082 within 1.1e-12
check center_of_curvature(conic_1, 0)
    ~= (0.80769230769230769, -0.44423076923076923, 0.79807692307692308) within 1e-11
check conic_1(0.2) ~= (0.73195876288659794, 0.56701030927835052, 1.0721649484536082) within 1.1e-12
check derivative(conic_1, 0.2)
    ~= (5.792326495908173, 2.4178977574662557, 0.026570305027101711) within 5.8e-12
check derivative(conic_1, 0.2, order = 2)
    ~= (23.301061826086671, -7.1205678265928761, -4.326576988691459) within 2.3e-11
check tangent(conic_1, 0.2)
    ~= (0.922817976998621, 0.38521300874713079, 0.0042331099862322064) within 1e-12
check normal(conic_1, 0.2)
    ~= (0.37168611901947904, -0.88741668554823716, -0.27265556135684968) within 1e-12
check binormal(conic_1, 0.2)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_1, 0.2) ~= 0.41015444156860807 within 1e-12
check center_of_curvature(conic_1, 0.2)
    ~= (1.6381689153306151, -1.5966056256225901, 0.40740179164346418) within 1.6e-11
check conic_1(0.5) ~= (3.3846153846153846, 0.76923076923076923, 0.84615384615384615) within 3.4e-12
check derivative(conic_1, 0.5)
    ~= (10.769230769230769, -1.5384615384615385, -1.5384615384615385) within 1.1e-11
check derivative(conic_1, 0.5, order = 2)
    ~= (1.4201183431952663, -15.621301775147929, -4.2603550295857988) within 1.6e-11
check tangent(conic_1, 0.5)
    ~= (0.98019605881960686, -0.14002800840280098, -0.14002800840280098) within 1e-12
check normal(conic_1, 0.5)
    ~= (-0.17017425192460682, -0.95723016707591335, -0.23398959639633438) within 1e-12
check binormal(conic_1, 0.5)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_1, 0.5) ~= 0.13013325147175816 within 1e-12
check center_of_curvature(conic_1, 0.5)
    ~= (2.0769230769230769, -6.5865384615384615, -0.95192307692307692) within 6.6e-11
check conic_1(0.9) ~= (6.6727688787185355, -0.61784897025171625, 0.13501144164759725) within 6.7e-12
check derivative(conic_1, 0.9)
    ~= (4.2179620776146914, -4.013740450020684, -1.5002434950175159) within 4.2e-12
check derivative(conic_1, 0.9, order = 2)
    ~= (-20.288315691383076, 3.1129928200813932, 2.9548208149038483) within 2e-11
check tangent(conic_1, 0.9)
    ~= (0.70151380867832093, -0.66754852185218249, -0.24951422245355549) within 1e-12
check normal(conic_1, 0.9)
    ~= (-0.70542325307380241, -0.70019740564386708, -0.11000739589851213) within 1e-12
check binormal(conic_1, 0.9)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_1, 0.9) ~= 0.32659528253353119 within 1e-12
check center_of_curvature(conic_1, 0.9)
    ~= (4.5128379464602676, -2.7617789137957677, -0.20181949799470389) within 4.5e-11
check length(conic_1) ~= 7.8590142623655009 within 7.9e-10
curve conic_2 = conic((0, 0, 1), (3, 5, 2), (7, -1, 0), 0.7)
check conic_kind(conic_2) == "ellipse"
check conic_2(0) ~= (0, 0, 1) within 1e-12
check derivative(conic_2, 0) ~= (4.2, 7, 1.4) within 7e-12
check derivative(conic_2, 0, order = 2) ~= (10.64, -7.6, -3.12) within 1.1e-11
check tangent(conic_2, 0)
    ~= (0.50709255283710995, 0.84515425472851658, 0.16903085094570332) within 1e-12
check normal(conic_2, 0)
    ~= (0.85592098502182583, -0.47075654176200421, -0.21398024625545646) within 1e-12
check binormal(conic_2, 0)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_2, 0) ~= 0.19464092370758722 within 1e-12
check center_of_curvature(conic_2, 0)
    ~= (4.3974358974358974, -2.4185897435897436, -0.099358974358974359) within 4.4e-11
check conic_2(0.2) ~= (1.0530973451327434, 1.1946902654867257, 1.2035398230088496) within 1.2e-12
check derivative(conic_2, 0.2)
    ~= (6.3043308011590571, 4.6793014331584306, 0.56778134544600204) within 6.3e-12
check derivative(conic_2, 0.2, order = 2)
    ~= (9.8179218613664038, -15.558109830431417, -5.1277048881520996) within 1.6e-11
check tangent(conic_2, 0.2)
    ~= (0.80089095803638561, 0.59445012102700671, 0.072129931003276965) within 1e-12
check normal(conic_2, 0.2)
    ~= (0.59018409253312662, -0.76323422978035581, -0.26297575441937012) within 1e-12
check binormal(conic_2, 0.2)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_2, 0.2) ~= 0.30691508207309914 within 1e-12
check center_of_curvature(conic_2, 0.2)
    ~= (2.9760529996631395, -1.2921025784002143, 0.34670426887750785) within 3e-11
check conic_2(0.5) ~= (3.2941176470588235, 1.7647058823529412, 1.1176470588235294) within 3.3e-12
check derivative(conic_2, 0.5)
    ~= (8.2352941176470588, -1.1764705882352941, -1.1764705882352941) within 8.2e-12
check derivative(conic_2, 0.5, order = 2)
    ~= (1.9377162629757785, -21.314878892733564, -5.8131487889273356) within 2.1e-11
check tangent(conic_2, 0.5)
    ~= (0.98019605881960686, -0.14002800840280098, -0.14002800840280098) within 1e-12
check normal(conic_2, 0.5)
    ~= (-0.17017425192460682, -0.95723016707591335, -0.23398959639633438) within 1e-12
check binormal(conic_2, 0.5)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_2, 0.5) ~= 0.30364425343410236 within 1e-12
check center_of_curvature(conic_2, 0.5)
    ~= (2.7336780866192631, -1.3877666451195863, 0.34704266321913381) within 2.7e-11
check conic_2(0.9) ~= (6.3932346723044397, -0.19027484143763214, 0.27695560253699789) within 6.4e-12
check derivative(conic_2, 0.9)
    ~= (6.5235172910083181, -7.7258647739005672, -2.7198083395536564) within 7.7e-12
check derivative(conic_2, 0.9, order = 2)
    ~= (-8.8102095202254895, -8.8317547646197642, -1.3967555148762022) within 8.8e-12
check tangent(conic_2, 0.9)
    ~= (0.62300583175405076, -0.73783184665082339, -0.25974583667169571) within 1e-12
check normal(conic_2, 0.9)
    ~= (-0.7756334980801391, -0.62570088857638018, -0.08301249719587488) within 1e-12
check binormal(conic_2, 0.9)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_2, 0.9) ~= 0.11378311095194764 within 1e-12
check center_of_curvature(conic_2, 0.9)
    ~= (-0.42353709277501112, -5.689341296393529, -0.45261222612724331) within 5.7e-11
check length(conic_2) ~= 8.8865529681635501 within 8.9e-10
curve conic_3 = conic((0, 0, 1), (3, 5, 2), (7, -1, 0), 1)
check conic_kind(conic_3) == "parabola"
check conic_3(0) ~= (0, 0, 1) within 1e-12
check derivative(conic_3, 0) ~= (6, 10, 2) within 1e-11
check derivative(conic_3, 0, order = 2) ~= (2, -22, -6) within 2.2e-11
check tangent(conic_3, 0)
    ~= (0.50709255283710995, 0.84515425472851658, 0.16903085094570332) within 1e-12
check normal(conic_3, 0)
    ~= (0.85592098502182583, -0.47075654176200421, -0.21398024625545646) within 1e-12
check binormal(conic_3, 0)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_3, 0) ~= 0.095374052616717736 within 1e-12
check center_of_curvature(conic_3, 0)
    ~= (8.9743589743589744, -4.9358974358974359, -1.2435897435897436) within 9e-11
check conic_3(0.2) ~= (1.24, 1.56, 1.28) within 1.6e-12
check derivative(conic_3, 0.2) ~= (6.4, 5.6, 0.8) within 6.4e-12
check derivative(conic_3, 0.2, order = 2) ~= (2, -22, -6) within 2.2e-11
check tangent(conic_3, 0.2)
    ~= (0.74926864926535517, 0.65561006810718578, 0.093658581158169397) within 1e-12
check normal(conic_3, 0.2)
    ~= (0.65447695220814302, -0.71138799153059024, -0.25609967695101249) within 1e-12
check binormal(conic_3, 0.2)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_3, 0.2) ~= 0.25350997505201955 within 1e-12
check center_of_curvature(conic_3, 0.2)
    ~= (3.8216615384615385, -1.2461538461538462, 0.26978461538461538) within 3.8e-11
check conic_3(0.5) ~= (3.25, 2.25, 1.25) within 3.2e-12
check derivative(conic_3, 0.5) ~= (7, -1, -1) within 7e-12
check derivative(conic_3, 0.5, order = 2) ~= (2, -22, -6) within 2.2e-11
check tangent(conic_3, 0.5)
    ~= (0.98019605881960686, -0.14002800840280098, -0.14002800840280098) within 1e-12
check normal(conic_3, 0.5)
    ~= (-0.17017425192460682, -0.95723016707591335, -0.23398959639633438) within 1e-12
check binormal(conic_3, 0.5)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_3, 0.5) ~= 0.43377750490586052 within 1e-12
check center_of_curvature(conic_3, 0.5)
    ~= (2.8576923076923077, 0.043269230769230769, 0.71057692307692308) within 2.9e-11
check conic_3(0.9) ~= (6.21, 0.09, 0.37) within 6.2e-12
check derivative(conic_3, 0.9) ~= (7.8, -9.8, -3.4) within 9.8e-12
check derivative(conic_3, 0.9, order = 2) ~= (2, -22, -6) within 2.2e-11
check tangent(conic_3, 0.9)
    ~= (0.60099656018370673, -0.75509824228209307, -0.26197285956725678) within 1e-12
check normal(conic_3, 0.9)
    ~= (-0.79280938717382876, -0.6047512549800367, -0.075691447397501368) within 1e-12
check binormal(conic_3, 0.9)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_3, 0.9) ~= 0.072269398715258597 within 1e-12
check center_of_curvature(conic_3, 0.9)
    ~= (-4.7601948717948718, -8.2780128205128205, -0.67735128205128205) within 8.3e-11
check length(conic_3) ~= 9.4709920291408116 within 9.5e-10
curve conic_4 = conic((0, 0, 1), (3, 5, 2), (7, -1, 0), 1.5)
check conic_kind(conic_4) == "hyperbola"
check conic_4(0) ~= (0, 0, 1) within 1e-12
check derivative(conic_4, 0) ~= (9, 15, 3) within 1.5e-11
check derivative(conic_4, 0, order = 2) ~= (-22, -62, -14) within 6.2e-11
check tangent(conic_4, 0)
    ~= (0.50709255283710995, 0.84515425472851658, 0.16903085094570332) within 1e-12
check normal(conic_4, 0)
    ~= (0.85592098502182583, -0.47075654176200421, -0.21398024625545646) within 1e-12
check binormal(conic_4, 0)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_4, 0) ~= 0.042388467829652327 within 1e-12
check center_of_curvature(conic_4, 0)
    ~= (20.192307692307692, -11.105769230769231, -4.0480769230769231) within 2e-10
check conic_4(0.2) ~= (1.4827586206896552, 2.0344827586206897, 1.3793103448275862) within 2e-12
check derivative(conic_4, 0.2)
    ~= (6.3020214030915577, 6.361474435196195, 1.0107015457788347) within 6.4e-12
check derivative(conic_4, 0.2, order = 2)
    ~= (-7.4111279675263438, -30.659313624994875, -7.2881216942064045) within 3.1e-11
check tangent(conic_4, 0.2)
    ~= (0.69933869196293882, 0.70593622679277787, 0.11215809210726377) within 1e-12
check normal(conic_4, 0.2)
    ~= (0.70757966595087759, -0.66147674154048046, -0.24855489682127145) within 1e-12
check binormal(conic_4, 0.2)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_4, 0.2) ~= 0.2074734989381278 within 1e-12
check center_of_curvature(conic_4, 0.2)
    ~= (4.8932166771274566, -1.1537641496639406, 0.18130241565396758) within 4.9e-11
check conic_4(0.5) ~= (3.2, 2.8, 1.4) within 3.2e-12
check derivative(conic_4, 0.5) ~= (5.6, -0.8, -0.8) within 5.6e-12
check derivative(conic_4, 0.5, order = 2) ~= (1.92, -21.12, -5.76) within 2.1e-11
check tangent(conic_4, 0.5)
    ~= (0.98019605881960686, -0.14002800840280098, -0.14002800840280098) within 1e-12
check normal(conic_4, 0.5)
    ~= (-0.17017425192460682, -0.95723016707591335, -0.23398959639633438) within 1e-12
check binormal(conic_4, 0.5)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_4, 0.5) ~= 0.65066625735879078 within 1e-12
check center_of_curvature(conic_4, 0.5)
    ~= (2.9384615384615385, 1.3288461538461538, 1.0403846153846154) within 2.9e-11
check conic_4(0.9) ~= (5.944954128440367, 0.49541284403669725, 0.50458715596330275) within 5.9e-12
check derivative(conic_4, 0.9)
    ~= (9.3173975254608198, -12.296944701624442, -4.2168167662654659) within 1.2e-11
check derivative(conic_4, 0.9, order = 2)
    ~= (20.915361740933987, -46.499344802317168, -14.43828671018178) within 4.6e-11
check tangent(conic_4, 0.9)
    ~= (0.58255323806617428, -0.76884397544234926, -0.26364875543916289) within 1e-12
check normal(conic_4, 0.9)
    ~= (-0.80645850145075972, -0.58717661510267943, -0.069629793295361986) within 1e-12
check binormal(conic_4, 0.9)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_4, 0.9) ~= 0.044725689298429869 within 1e-12
check center_of_curvature(conic_4, 0.9)
    ~= (-12.086260462120925, -12.632984377183831, -1.0522316295619635) within 1.3e-10
check length(conic_4) ~= 10.182843579683618 within 1e-9
curve conic_5 = conic((0, 0, 1), (3, 5, 2), (7, -1, 0), 40)
check conic_kind(conic_5) == "hyperbola"
check conic_5(0) ~= (0, 0, 1) within 1e-12
check derivative(conic_5, 0) ~= (240, 400, 80) within 4e-10
check derivative(conic_5, 0, order = 2) ~= (-37906, -63202, -12642) within 6.3e-8
check tangent(conic_5, 0)
    ~= (0.50709255283710995, 0.84515425472851658, 0.16903085094570332) within 1e-12
check normal(conic_5, 0)
    ~= (0.85592098502182583, -0.47075654176200421, -0.21398024625545646) within 1e-12
check binormal(conic_5, 0)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_5, 0) ~= 5.9608782885448585e-5 within 1e-12
check center_of_curvature(conic_5, 0)
    ~= (14358.974358974359, -7897.4358974358974, -3588.7435897435897) within 1.4e-7
check conic_5(0.2) ~= (2.8694362017804154, 4.7448071216617211, 1.9465875370919881) within 4.7e-12
check derivative(conic_5, 0.2)
    ~= (0.92807015999084257, 1.3014114767234016, 0.24478510861238542) within 1.3e-12
check derivative(conic_5, 0.2, order = 2)
    ~= (-7.8067744434271556, -13.621825166326551, -2.7629251023567602) within 1.4e-11
check tangent(conic_5, 0.2)
    ~= (0.57392188363454065, 0.80479748008714524, 0.15137598069298131) within 1e-12
check normal(conic_5, 0.2)
    ~= (0.8126236898029558, -0.53684117944026701, -0.22681333035827614) within 1e-12
check binormal(conic_5, 0.2)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_5, 0.2) ~= 0.61013864319756348 within 1e-12
check center_of_curvature(conic_5, 0.2)
    ~= (4.201303473035725, 3.8649395941325111, 1.5748468960311108) within 4.2e-11
check conic_5(0.5) ~= (3.0121951219512195, 4.8658536585365854, 1.9634146341463415) within 4.9e-12
check derivative(conic_5, 0.5)
    ~= (0.34146341463414634, -0.048780487804878049, -0.048780487804878049) within 1e-12
check derivative(conic_5, 0.5, order = 2)
    ~= (0.19036287923854848, -2.0939916716240333, -0.57108863771564545) within 2.1e-12
check tangent(conic_5, 0.5)
    ~= (0.98019605881960686, -0.14002800840280098, -0.14002800840280098) within 1e-12
check normal(conic_5, 0.5)
    ~= (-0.17017425192460682, -0.95723016707591335, -0.23398959639633438) within 1e-12
check binormal(conic_5, 0.5)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_5, 0.5) ~= 17.351100196234421 within 1.7e-11
check center_of_curvature(conic_5, 0.5)
    ~= (3.0023874296435272, 4.8106853893058161, 1.9499290572232645) within 4.8e-11
check conic_5(0.9) ~= (3.4002493765586035, 4.3877805486284289, 1.7967581047381546) within 4.4e-12
check derivative(conic_5, 0.9)
    ~= (4.0867283163661918, -5.9853483498236951, -2.0052735990447821) within 6e-12
check derivative(conic_5, 0.9, order = 2)
    ~= (71.628752696464199, -107.79023796408507, -35.905720800702828) within 1.1e-10
check tangent(conic_5, 0.9)
    ~= (0.54346489887862545, -0.79594885783418256, -0.26666705720674546) within 1e-12
check normal(conic_5, 0.9)
    ~= (-0.83330036207266534, -0.54987530551016395, -0.056988200179236267) within 1e-12
check binormal(conic_5, 0.9)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_5, 0.9) ~= 0.028810206676640287 within 1e-12
check center_of_curvature(conic_5, 0.9)
    ~= (-25.52354042562691, -14.698347908617608, -0.18129782588601149) within 2.6e-10
check length(conic_5) ~= 13.190345292218923 within 1.3e-9
curve conic_6 = conic((0, 0, 1), (3, 5, 2), (7, -1, 0), 1000)
check conic_kind(conic_6) == "hyperbola"
check conic_6(0) ~= (0, 0, 1) within 1e-12
check derivative(conic_6, 0) ~= (6000, 10000, 2000) within 1e-8
check derivative(conic_6, 0, order = 2) ~= (-23987986, -39980002, -7996002) within 4e-5
check tangent(conic_6, 0)
    ~= (0.50709255283710995, 0.84515425472851658, 0.16903085094570332) within 1e-12
check normal(conic_6, 0)
    ~= (0.85592098502182583, -0.47075654176200421, -0.21398024625545646) within 1e-12
check binormal(conic_6, 0)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_6, 0) ~= 9.5374052616717736e-8 within 1e-12
check center_of_curvature(conic_6, 0)
    ~= (8974358.9743589744, -4935897.4358974359, -2243588.7435897436) within 9e-5
check conic_6(0.2) ~= (2.994511662716727, 4.9892727953099663, 1.9977547711113883) within 5e-12
check derivative(conic_6, 0.2)
    ~= (0.040474674863376968, 0.057564466079619476, 0.010888051614281234) within 1e-12
check derivative(conic_6, 0.2, order = 2)
    ~= (-0.3647669833990012, -0.63266332111098365, -0.12809382309246925) within 1e-12
check tangent(conic_6, 0.2)
    ~= (0.56840977951963359, 0.80841181758543106, 0.15290734362567832) within 1e-12
check normal(conic_6, 0.2)
    ~= (0.81648877046168325, -0.53138288369654478, -0.22578378733716265) within 1e-12
check binormal(conic_6, 0.2)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_6, 0.2) ~= 13.269091342639446 within 1.3e-11
check center_of_curvature(conic_6, 0.2)
    ~= (3.0560447963261057, 4.9492261282115964, 1.9807390025476721) within 4.9e-11
check conic_6(0.5) ~= (3.0004995004995005, 4.9945054945054945, 1.9985014985014985) within 5e-12
check derivative(conic_6, 0.5)
    ~= (0.013986013986013986, -0.001998001998001998, -0.001998001998001998) within 1e-12
check derivative(conic_6, 0.5, order = 2)
    ~= (0.0079840239680399521, -0.087824263648439473, -0.023952071904119856) within 1e-12
check tangent(conic_6, 0.5)
    ~= (0.98019605881960686, -0.14002800840280098, -0.14002800840280098) within 1e-12
check normal(conic_6, 0.5)
    ~= (-0.17017425192460682, -0.95723016707591335, -0.23398959639633438) within 1e-12
check binormal(conic_6, 0.5)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_6, 0.5) ~= 433.77750490586052 within 4.3e-10
check center_of_curvature(conic_6, 0.5)
    ~= (3.0001071928071928, 4.9922987637362637, 1.9979620754245754) within 5e-11
check conic_6(0.9) ~= (3.0177524610109501, 4.9728459241234377, 1.9909855104523836) within 5e-12
check derivative(conic_6, 0.9)
    ~= (0.2000637854214283, -0.29423224688141369, -0.098488884486838161) within 1e-12
check derivative(conic_6, 0.9, order = 2)
    ~= (3.9403978732163403, -5.9236220220840966, -1.9736266240449034) within 5.9e-12
check tangent(conic_6, 0.9)
    ~= (0.54190534130582338, -0.79697595361191207, -0.26677318161427406) within 1e-12
check normal(conic_6, 0.9)
    ~= (-0.83431540247547199, -0.54838559906494561, -0.05648932580914653) within 1e-12
check binormal(conic_6, 0.9)
    ~= (-0.10127393670836666, 0.25318484177091665, -0.96210239872948329) within 1e-12
check curvature(conic_6, 0.9) ~= 0.53106507966246987 within 1e-12
check center_of_curvature(conic_6, 0.9)
    ~= (1.4467295592495698, 3.9402312407903061, 1.8846156360764416) within 3.9e-11
check length(conic_6) ~= 13.390805435255505 within 1.3e-9
curve ellipse_0 = ellipse((1, -2, 3), 5, 3)
check length(ellipse_0) ~= 25.526998863398128 within 2.6e-9
check [for t in linspace(0, 1, 33): (ellipse_0(t).x - 1)^2/5^2 + (ellipse_0(t).y + 2)^2/3^2]
    ~= [for t in linspace(0, 1, 33): 1] within 1e-12
check curvature(ellipse_0, 0) ~= 0.55555555555555556 within 1e-12
check curvature(ellipse_0, 0.25) ~= 0.12 within 1e-12
curve ellipse_1 = ellipse((1, -2, 3), 10, 0.1)
check length(ellipse_1) ~= 40.010983297226519 within 4e-9
check [for t in linspace(0, 1, 33): (ellipse_1(t).x - 1)^2/10^2 + (ellipse_1(t).y + 2)^2/0.1^2]
    ~= [for t in linspace(0, 1, 33): 1] within 1e-12
check curvature(ellipse_1, 0) ~= 1000 within 1e-9
check curvature(ellipse_1, 0.25) ~= 0.001 within 1e-12
curve ellipse_2 = ellipse((1, -2, 3), 1000, 999)
check length(ellipse_2) ~= 6280.0441074215323 within 6.3e-7
check [
    for t in linspace(0, 1, 33): (ellipse_2(t).x - 1)^2/1000^2 + (ellipse_2(t).y + 2)^2/999^2
] ~= [for t in linspace(0, 1, 33): 1] within 1e-12
check curvature(ellipse_2, 0) ~= 0.001002003004005006 within 1e-12
check curvature(ellipse_2, 0.25) ~= 0.000999 within 1e-12
curve ellipse_3 = ellipse((1, -2, 3), 2, 7)
check length(ellipse_3) ~= 30.501790686924979 within 3.1e-9
check [for t in linspace(0, 1, 33): (ellipse_3(t).x - 1)^2/2^2 + (ellipse_3(t).y + 2)^2/7^2]
    ~= [for t in linspace(0, 1, 33): 1] within 1e-12
check curvature(ellipse_3, 0) ~= 0.040816326530612245 within 1e-12
check curvature(ellipse_3, 0.25) ~= 1.75 within 1.7e-12
curve arc_0 = arc((1, 2, 3), 2.5, 10deg, 100deg)
check length(arc_0) ~= 3.9269908169872415 within 3.9e-12
check arc_0.start ~= (3.4620193825305201, 2.4341204441673259, 3) within 3.5e-12
check arc_0.end ~= (0.56587955583267413, 4.4620193825305201, 3) within 4.5e-12
check arc_0(0.5) ~= (2.4339410908776152, 4.0478801107224795, 3) within 4e-12
curve arc_1 = arc((1, 2, 3), 1000, 0deg, 359deg)
check length(arc_1) ~= 6265.7320146596432 within 6.3e-9
check arc_1.start ~= (1001, 2, 3) within 1e-9
check arc_1.end ~= (1000.8476951563912, -15.452406437283513, 3) within 1e-9
check arc_1(0.5) ~= (-998.96192306417129, 10.726535498373935, 3) within 1e-9
curve arc_2 = arc((1, 2, 3), 0.01, -200deg, -90deg)
check length(arc_2) ~= 0.019198621771937625 within 1e-12
check arc_2.start ~= (0.99060307379214092, 2.0034202014332567, 3) within 3e-12
check arc_2.end ~= (1, 1.99, 3) within 3e-12
check arc_2(0.5) ~= (0.99180847955711008, 1.9942642356364895, 3) within 3e-12
