// SPDX-License-Identifier: Apache-2.0
//
// Renders a Request (renderer.ts) of a scene (scene.ts), a pixel a thread. It follows wellstrat.wgsl,
// and radiance.ts says what the functions do.

struct Request {
    size: u32,
    source: u32,
    first: u32,
    count: u32,
    seed: u32,
}

@group(0) @binding(0) var<storage, read> wellstratWords: array<u32>;
@group(0) @binding(1) var<uniform> request: Request;
@group(0) @binding(2) var<uniform> scene: array<vec4f, SCENE_VECTORS>;
@group(0) @binding(3) var<storage, read_write> sums: array<vec4f>;

const pi = 3.14159265;
const never = 1e30; // a distance
const offset = 1e-3;

fn squareToDisk(xi: vec2f) -> vec2f {
    let p = 2.0 * xi - 1.0;
    if (all(p == vec2f(0.0))) { return p; }
    let wide = abs(p.x) > abs(p.y);
    let radius = select(p.y, p.x, wide);
    let angle = select(pi / 2.0 - pi / 4.0 * (p.x / p.y), pi / 4.0 * (p.y / p.x), wide);
    return radius * vec2f(cos(angle), sin(angle));
}

fn sphereDistance(sphere: vec4f, origin: vec3f, direction: vec3f) -> f32 {
    let toCenter = sphere.xyz - origin;
    let along = dot(toCenter, direction);
    let square = along * along - dot(toCenter, toCenter) + sphere.w * sphere.w;
    if (along < 0.0 || square < 0.0) { return never; }
    return along - sqrt(square);
}

fn radiance(image: vec2f, onLens: vec2f, onLight: vec2f) -> vec3f {
    let spheres = i32(scene[3].w);
    let right = scene[1].xyz;
    let down = scene[2].xyz;
    let aim = scene[3].xyz + right * (2.0 * image.x - 1.0) + down * (2.0 * image.y - 1.0);
    let lens = squareToDisk(onLens);
    let shift = (scene[0].w / length(right)) * (right * lens.x + down * lens.y);
    let origin = scene[0].xyz + shift;
    let direction = normalize(scene[1].w * aim - shift);

    var distance = never;
    if (direction.y < 0.0) { distance = -origin.y / direction.y; }
    var hit = -1;
    for (var i = 0; i < spheres; i++) {
        let other = sphereDistance(scene[7 + 2 * i], origin, direction);
        if (other < distance) {
            distance = other;
            hit = i;
        }
    }
    if (distance == never) {
        return vec3f(0.3, 0.35, 0.42) - vec3f(0.2, 0.2, 0.16) * max(direction.y, 0.0);
    }

    var position = origin + direction * distance;
    var normal = vec3f(0.0, 1.0, 0.0);
    var color = vec3f(0.6, 0.6, 0.58);
    if (hit >= 0) {
        let sphere = scene[7 + 2 * hit];
        normal = (position - sphere.xyz) / sphere.w;
        color = scene[8 + 2 * hit].xyz;
    } else if (scene[6].w != 0.0) {
        let cell = vec2i(floor(position.xz));
        if (((cell.x + cell.y) & 1) != 0) { color = vec3f(0.22); }
    }

    position += offset * normal;
    let source = scene[4].xyz + scene[5].xyz * onLight.x + scene[6].xyz * onLight.y;
    let range = length(source - position);
    let toLight = (source - position) / range;
    let cosSurface = dot(normal, toLight);
    var light = scene[5].w * (0.6 + 0.4 * normal.y);
    if (cosSurface > 0.0 && toLight.y > 0.0) {
        var blocked = false;
        for (var i = 0; i < spheres; i++) {
            blocked = blocked || sphereDistance(scene[7 + 2 * i], position, toLight) < range;
        }
        if (!blocked) { light += scene[4].w * cosSurface * toLight.y / (pi * range * range); }
    }
    return color * light;
}

/// The sample of a slot's domain.
fn drawn(pixel: vec2u, slot: u32) -> vec2f {
    let scramble = wellstratJointScramble(slot);
    let order = vec2u(slot, 1u);
    switch (request.source) {
        case 0u: { return wellstratRandomSample2D(wellstratNewDomain(pixel, scramble)); }
        case 1u: { return wellstratSample2D(wellstratNewDomain(pixel, scramble)); }
        case 2u: { return wellstratJointSample2D(wellstratNewDomain(pixel, scramble), order); }
        case 3u: { return wellstratLongSample2D(wellstratNewDomain(pixel, scramble), order); }
        default: { return wellstratBlueSample2D(wellstratNewBlueDomain(pixel, scramble), order); }
    }
}

@compute @workgroup_size(8, 8)
fn render(@builtin(global_invocation_id) thread: vec3u) {
    if (any(thread.xy >= vec2u(request.size))) { return; }
    let x = i32(thread.x);
    let y = i32(thread.y);
    var sum = vec3f(0.0);
    for (var i = request.first; i < request.first + request.count; i++) {
        var pixel: vec2u;
        if (request.source == 4u) {
            pixel = wellstratBlueContext(x, y, request.seed, i);
        } else {
            pixel = wellstratCameraContext(x, y, request.seed, i, 0u);
        }
        let image = (vec2f(thread.xy) + drawn(pixel, 0u)) / f32(request.size);
        sum += radiance(image, drawn(pixel, 1u), drawn(pixel, 2u));
    }
    sums[thread.y * request.size + thread.x] = vec4f(sum, 0.0);
}
