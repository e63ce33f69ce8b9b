"""Writes the skin of an aircraft as a script of 10,000 surfaces: `python3 aircraft.py > aircraft.geo`.

Panels between frames and stringers of a body, two wings and a fin; each is a surface with a name, through sixteen points of its form.
"""

FORMS = {
    # The turn of a station, v, runs once around; u along it.
    "body": (
        100,
        64,
        "(40*u, 2*sqrt(1 - (1 - 1.9*u)^4*0.9)*cos(v*360deg), 2*sqrt(1 - (1 - 1.9*u)^4*0.9)*sin(v*360deg) + u)",
    ),
    "left": (50, 30, "(16 + 8*u + (6 - 4*u)*cos(v*360deg)/2, 2 + 16*u, (0.8 - 0.5*u)*sin(v*360deg)/2 + u)"),
    "right": (50, 30, "(16 + 8*u + (6 - 4*u)*cos(v*360deg)/2, -2 - 16*u, (0.8 - 0.5*u)*sin(v*360deg)/2 + u)"),
    "fin": (30, 20, "(34 + 4*u + (4 - 2*u)*cos(v*360deg)/2, (0.5 - 0.3*u)*sin(v*360deg)/2, 2 + 6*u)"),
}


def main():
    print("geo 1\nunit m\n\nparam grown = 0m in 0m..1m \"By how much one panel stands out\"\n")
    print("let quarters = [0, 1/3, 2/3, 1]")
    n_panels = 0
    for name, (n_u, n_v, form) in FORMS.items():
        print(f"fn {name}(u, v) = {form}")
        print(f"fn {name}_panel(u, v, du, dv) = interpolate([for a in quarters: [for b in quarters: {name}(u + a*du, v + b*dv)]])")
        for i in range(n_u):
            for j in range(n_v):
                print(f"surface {name}_{i}_{j} = {name}_panel({i}/{n_u}, {j}/{n_v}, 1/{n_u}, 1/{n_v})")
                n_panels += 1
    print("surface grown_panel = translate(body_50_16, (0, 0, grown/1m))")
    print("export all to \"aircraft.step\"")
    print(f"// {n_panels} panels")


main()
