#!/usr/bin/env python3
"""Write the same scene for POV-Ray (.pov), Tachyon (.dat) and raylab (.toml, with a .csv for many spheres).

    bench/peers/scenes.py FOLDER small|smallng|flake4|flake5|flake6|grid100 ...

small     a plane and five balls, one of them glass, three lights, five levels; smallng without the glass
flakeN    a sphere flake of N levels over a plane: 7,381 spheres for N = 4, 597,871 for N = 6; three levels
gridN     N x N x N small spheres over a plane, three levels

Geometry, lights and depth are the same, and so the rays. The shading differs in detail (the peers have no fall-off by
(1 + r)^2 and no tinted highlight, and their image is mirrored): compare times, not pixels.
"""
import math
import os
import random
import sys

WIDTH, HEIGHT = 1280, 960


# ---- Vectors ---------------------------------------------------------------------------------------------------------


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def difference(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def rotated(v, axis, angle):
    c, s = math.cos(angle), math.sin(angle)
    across, along = cross(axis, v), dot(axis, v)
    return [v[i] * c + across[i] * s + axis[i] * along * (1 - c) for i in range(3)]


# ---- Scenes ----------------------------------------------------------------------------------------------------------


class Ball:
    def __init__(self, center, radius, color, shininess, glass=False):
        self.center, self.radius, self.color, self.shininess, self.glass = center, radius, color, shininess, glass


class Scene:
    """`lights`: ('point', position, strength) or ('directional', direction, strength)."""

    def __init__(self, name, camera, facing_point, up, half_width, levels, plane, balls, lights):
        self.name, self.up, self.half_width, self.levels = name, up, half_width, levels
        self.position = camera
        self.forward = unit(difference(facing_point, camera))
        self.right = unit(cross(up, self.forward))
        self.camera_up = cross(self.forward, self.right)
        self.half_height = half_width * HEIGHT / WIDTH
        self.plane_point, self.plane_normal, self.plane_color, self.plane_shininess = plane
        self.balls, self.lights, self.ambient = balls, lights, 0.1


def small(name):
    balls = [Ball([0, 1.2, 1.0], 1.2, [.9, .15, .1], 1000), Ball([-2.4, 0.8, 0.2], 0.8, [.1, .7, .2], 400),
             Ball([2.3, 0.9, 0.6], 0.9, [.15, .3, .9], 200), Ball([-0.9, 0.4, -1.9], 0.4, [.9, .8, .1], 50),
             Ball([1.0, 0.6, -2.0], 0.6, [.8, .8, .9], 1000, glass=name == 'small')]
    lights = [('point', [-4, 6, -5], .45), ('point', [5, 5, -3], .35), ('directional', unit([0.3, -1, 0.4]), .3)]
    return Scene(name, [0, 2.6, -8.5], [0, 0.9, 0], [0, 1, 0], 0.55, 5, ([0, 0, 0], [0, 1, 0], [.75, .75, .7], 100), balls, lights)


def flake_balls(levels):
    """Nine smaller balls around each: three groups of three."""
    d = 1 / math.sqrt(2)
    trio = [rotated(v, unit((1, -1, 0)), math.asin(2 / math.sqrt(6))) for v in [(d, d, 0), (d, 0, -d), (0, d, -d)]]
    directions = [rotated(v, (0, 0, 1), 2 * math.pi * n / 3) for n in range(3) for v in trio]

    def frame(z):
        if abs(z[2]) >= 1 - 1e-12:
            return [1, 0, 0], [0, 1 if z[2] > 0 else -1, 0], z
        axis, angle = unit(cross((0, 0, 1), z)), math.acos(max(-1, min(1, z[2])))
        return rotated((1, 0, 0), axis, angle), rotated((0, 1, 0), axis, angle), z

    balls = []

    def grow(center, radius, axis, level):
        balls.append(Ball(center, radius, [1, .9, .7], 100))
        if level == 0:
            return
        x, y, z = frame(axis)
        for v in directions:
            outwards = [v[0] * x[i] + v[1] * y[i] + v[2] * z[i] for i in range(3)]
            grow([center[i] + outwards[i] * (radius + radius / 3) for i in range(3)], radius / 3, outwards, level - 1)

    grow([0, 0, 0], 0.5, [0, 0, 1], levels)
    return balls


def flake(name):
    lights = [('point', [4, 3, 2], .4), ('point', [1, -4, 4], .4), ('directional', unit([3, -1, -5]), .3)]
    return Scene(name, [2.1, 1.3, 1.7], [0, 0, 0], [0, 0, 1], math.tan(math.pi / 8) * 4 / 3, 3,
                 ([0, 0, -.5], [0, 0, 1], [1, .75, .33], 20), flake_balls(int(name[5:])), lights)


def grid(name):
    n = int(name[4:])
    h = 1 / n
    random.seed(1)
    balls = []
    for k in range(n):
        for j in range(n):
            for i in range(n):
                center = [(at + .5 + random.uniform(-.25, .25)) * h for at in (i, j, k)]
                balls.append(Ball(center, .25 * h, [.3 + .7 * i * h, .3 + .7 * j * h, .3 + .7 * k * h], 100))
    lights = [('point', [-2, 3, -2], .4), ('point', [3, 4, -1], .4), ('directional', unit([.3, -1, .5]), .3)]
    return Scene(name, [1.5, 1.3, -1.6], [.5, .42, .5], [0, 1, 0], .4, 3, ([0, -.02, 0], [0, 1, 0], [.75, .75, .7], 20), balls, lights)


def scene_of(name):
    if name in ('small', 'smallng'):
        return small(name)
    for prefix, make in (('flake', flake), ('grid', grid)):
        if name.startswith(prefix) and name[len(prefix):].isdigit():
            return make(name)
    sys.exit(f'scenes.py: there is no scene {name!r}; there are small, smallng, flakeN and gridN')


# ---- raylab ----------------------------------------------------------------------------------------------------------


def array(v):
    return '[' + ', '.join(repr(float(x)) for x in v) + ']'


def write_raylab(scene, folder):
    many = len(scene.balls) >= 100
    with open(os.path.join(folder, scene.name + '.toml'), 'w') as out:
        out.write(f'max_bounces = {scene.levels - 1}\n[camera]\nposition = {array(scene.position)}\nfacing = {array(scene.forward)}\n'
                  f'up = {array(scene.camera_up)}\nhalf_field_of_view = {math.degrees(math.atan(scene.half_width))!r}\n'
                  f'[image]\nwidth = {WIDTH}\nheight = {HEIGHT}\n'
                  f'[[plane]]\npoint = {array(scene.plane_point)}\nnormal = {array(scene.plane_normal)}\n'
                  f'color = {array(scene.plane_color)}\nshininess = {scene.plane_shininess}\n')
        if many:
            out.write(f'[[sphere_cloud]]\nfile = "{scene.name}.csv"\nshininess = {scene.balls[0].shininess}\n')
        else:
            for ball in scene.balls:
                kind = 'transparent = true' if ball.glass else f'shininess = {ball.shininess}'
                out.write(f'[[sphere]]\ncenter = {array(ball.center)}\nradius = {ball.radius!r}\ncolor = {array(ball.color)}\n{kind}\n')
        for kind, v, strength in scene.lights:
            if kind == 'point':  # as bright on the first ball as without a fall-off
                r = math.sqrt(sum(x * x for x in difference(v, scene.balls[0].center)))
                out.write(f'[[point_light]]\nposition = {array(v)}\nintensity = {strength * (1 + r) ** 2!r}\n')
            else:
                out.write(f'[[directional_light]]\ndirection = {array(v)}\nintensity = {strength!r}\n')
        out.write(f'[[ambient_light]]\nintensity = {scene.ambient!r}\n')
    if many:
        with open(os.path.join(folder, scene.name + '.csv'), 'w') as out:
            out.write('x,y,z,radius,r,g,b\n')
            for ball in scene.balls:
                out.write('%.9g,%.9g,%.9g,%.9g,%.4g,%.4g,%.4g\n' % (*ball.center, ball.radius, *ball.color))


# ---- POV-Ray ---------------------------------------------------------------------------------------------------------


def specular_weight(shininess):
    return math.tanh(shininess / 400)


def pov_vector(v):
    return '<%.9g,%.9g,%.9g>' % tuple(v)


def pov_finish(scene, shininess):
    k = specular_weight(shininess)
    return (f'finish{{ambient {scene.ambient} diffuse 1 brilliance 1 specular {k:.7g} roughness {1 / shininess:.9g} '
            f'reflection {k:.7g}}}')


POV_GLASS = ('pigment{rgbt <1,1,1,1>} finish{ambient 0 diffuse 0 specular 0 reflection{0.04,1.0 falloff 5} conserve_energy} '
             'interior_texture{pigment{rgbt <1,1,1,1>} finish{ambient 0 diffuse 0 specular 0 reflection 0}} '
             'interior{ior 1.5} no_shadow')


def write_povray(scene, folder):
    with open(os.path.join(folder, scene.name + '.pov'), 'w') as out:
        out.write(f'#version 3.7;\nglobal_settings{{assumed_gamma 1.0 max_trace_level {scene.levels} adc_bailout 0 ambient_light rgb 1}}\n'
                  'background{rgb 0}\n'
                  f'camera{{perspective location {pov_vector(scene.position)} direction {pov_vector(scene.forward)} '
                  f'right {pov_vector([2 * scene.half_width * x for x in scene.right])} '
                  f'up {pov_vector([2 * scene.half_height * x for x in scene.camera_up])}}}\n')
        for kind, v, strength in scene.lights:
            if kind == 'point':
                out.write(f'light_source{{{pov_vector(v)} rgb {strength}}}\n')
            else:
                out.write(f'light_source{{{pov_vector([-1000 * x for x in v])} rgb {strength} parallel point_at <0,0,0>}}\n')
        out.write(f'plane{{{pov_vector(scene.plane_normal)},{dot(scene.plane_point, scene.plane_normal):.9g} '
                  f'pigment{{rgb {pov_vector(scene.plane_color)}}} {pov_finish(scene, scene.plane_shininess)}}}\n')
        finishes = {}
        for ball in scene.balls:
            if not ball.glass and ball.shininess not in finishes:
                finishes[ball.shininess] = f'F{len(finishes)}'
                out.write(f'#declare {finishes[ball.shininess]}={pov_finish(scene, ball.shininess)}\n')
            look = POV_GLASS if ball.glass else f'pigment{{rgb {pov_vector(ball.color)}}} finish{{{finishes[ball.shininess]}}}'
            out.write(f'sphere{{{pov_vector(ball.center)},{ball.radius:.9g} {look}}}\n')


# ---- Tachyon ---------------------------------------------------------------------------------------------------------


def numbers(v):
    return '%.9g %.9g %.9g' % tuple(v)


def tachyon_texture(scene, color, shininess, glass=False):
    if glass:
        return 'TEXTURE AMBIENT 0 DIFFUSE 0 SPECULAR 0.1 OPACITY 0.1 COLOR 1 1 1 TEXFUNC 0'
    k = specular_weight(shininess)
    return (f'TEXTURE AMBIENT {scene.ambient} DIFFUSE 1.0 SPECULAR {k:.7g} OPACITY 1.0 PHONG PLASTIC {k:.7g} '
            f'PHONG_SIZE {shininess} COLOR {numbers(color)} TEXFUNC 0')


def write_tachyon(scene, folder):
    with open(os.path.join(folder, scene.name + '.dat'), 'w') as out:
        out.write(f'BEGIN_SCENE\nRESOLUTION {WIDTH} {HEIGHT}\nCAMERA\n ZOOM {1 / (2 * scene.half_height):.9g} ASPECTRATIO 1.0 '
                  f'ANTIALIASING 0 RAYDEPTH {scene.levels}\n CENTER {numbers(scene.position)} VIEWDIR {numbers(scene.forward)} '
                  f'UPDIR {numbers(scene.camera_up)}\nEND_CAMERA\nBACKGROUND 0 0 0\n')
        for kind, v, strength in scene.lights:
            if kind == 'point':
                out.write(f'LIGHT CENTER {numbers(v)} RAD 0.00001 COLOR {strength} {strength} {strength}\n')
            else:
                out.write(f'DIRECTIONAL_LIGHT DIRECTION {numbers(v)} COLOR {strength} {strength} {strength}\n')
        out.write(f'PLANE CENTER {numbers(scene.plane_point)} NORMAL {numbers(scene.plane_normal)} '
                  f'{tachyon_texture(scene, scene.plane_color, scene.plane_shininess)}\n')
        for ball in scene.balls:
            out.write(f'SPHERE CENTER {numbers(ball.center)} RAD {ball.radius:.9g} '
                      f'{tachyon_texture(scene, ball.color, ball.shininess, ball.glass)}\n')
        out.write('END_SCENE\n')


def main(folder, names):
    os.makedirs(folder, exist_ok=True)
    for name in names:
        scene = scene_of(name)
        for write in (write_raylab, write_povray, write_tachyon):
            write(scene, folder)
        print(name, len(scene.balls), 'spheres')


if __name__ == '__main__':
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
