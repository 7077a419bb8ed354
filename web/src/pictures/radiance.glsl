// SPDX-License-Identifier: Apache-2.0
//
// Renders a Request (renderer.ts) of a scene (scene.ts) on WebGL2. It follows wellstrat.glsl, and
// radiance.ts says what the functions do. Sums leave as bits, since not every device has floats for
// targets.

uniform uint size, source, first, count, seed;
uniform vec4 scene[SCENE_VECTORS];
out uvec4 sums;

const float pi = 3.14159265;
const float never = 1e30; // a distance
const float offset = 1e-3;

vec2 squareToDisk(vec2 xi) {
    vec2 p = 2.0 * xi - 1.0;
    if (p == vec2(0.0)) return p;
    bool wide = abs(p.x) > abs(p.y);
    float radius = wide ? p.x : p.y;
    float angle = wide ? pi / 4.0 * (p.y / p.x) : pi / 2.0 - pi / 4.0 * (p.x / p.y);
    return radius * vec2(cos(angle), sin(angle));
}

float sphereDistance(vec4 sphere, vec3 origin, vec3 direction) {
    vec3 toCenter = sphere.xyz - origin;
    float along = dot(toCenter, direction);
    float square = along * along - dot(toCenter, toCenter) + sphere.w * sphere.w;
    return along < 0.0 || square < 0.0 ? never : along - sqrt(square);
}

vec3 radiance(vec2 image, vec2 onLens, vec2 onLight) {
    int spheres = int(scene[3].w);
    vec3 right = scene[1].xyz, down = scene[2].xyz;
    vec3 aim = scene[3].xyz + right * (2.0 * image.x - 1.0) + down * (2.0 * image.y - 1.0);
    vec2 lens = squareToDisk(onLens);
    vec3 shift = (scene[0].w / length(right)) * (right * lens.x + down * lens.y);
    vec3 origin = scene[0].xyz + shift;
    vec3 direction = normalize(scene[1].w * aim - shift);

    float range = direction.y < 0.0 ? -origin.y / direction.y : never;
    int hit = -1;
    for (int i = 0; i < spheres; ++i) {
        float other = sphereDistance(scene[7 + 2 * i], origin, direction);
        if (other < range) {
            range = other;
            hit = i;
        }
    }
    if (range == never) {
        return vec3(0.3, 0.35, 0.42) - vec3(0.2, 0.2, 0.16) * max(direction.y, 0.0);
    }

    vec3 position = origin + direction * range;
    vec3 normal = vec3(0.0, 1.0, 0.0);
    vec3 color = vec3(0.6, 0.6, 0.58);
    if (hit >= 0) {
        vec4 sphere = scene[7 + 2 * hit];
        normal = (position - sphere.xyz) / sphere.w;
        color = scene[8 + 2 * hit].xyz;
    } else if (scene[6].w != 0.0) {
        ivec2 cell = ivec2(floor(position.xz));
        if (((cell.x + cell.y) & 1) != 0) color = vec3(0.22);
    }

    position += offset * normal;
    vec3 onSource = scene[4].xyz + scene[5].xyz * onLight.x + scene[6].xyz * onLight.y;
    range = length(onSource - position);
    vec3 toLight = (onSource - position) / range;
    float cosSurface = dot(normal, toLight);
    float light = scene[5].w * (0.6 + 0.4 * normal.y);
    if (cosSurface > 0.0 && toLight.y > 0.0) {
        bool blocked = false;
        for (int i = 0; i < spheres; ++i) {
            blocked = blocked || sphereDistance(scene[7 + 2 * i], position, toLight) < range;
        }
        if (!blocked) light += scene[4].w * cosSurface * toLight.y / (pi * range * range);
    }
    return color * light;
}

/// The sample of a slot's domain.
vec2 drawn(uvec2 pixel, uint slot) {
    uint scramble = wellstratJointScramble(slot);
    uvec2 order = uvec2(slot, 1u);
    switch (source) {
    case 0u: return wellstratRandomSample2D(wellstratNewDomain(pixel, scramble));
    case 1u: return wellstratSample2D(wellstratNewDomain(pixel, scramble));
    case 2u: return wellstratJointSample2D(wellstratNewDomain(pixel, scramble), order);
    case 3u: return wellstratLongSample2D(wellstratNewDomain(pixel, scramble), order);
    default: return wellstratBlueSample2D(wellstratNewBlueDomain(pixel, scramble), order);
    }
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
    for (uint i = first; i < first + count; ++i) {
        uvec2 pixel = source == 4u ? wellstratBlueContext(at.x, at.y, seed, i)
                                   : wellstratCameraContext(at.x, at.y, seed, i, 0u);
        vec2 image = (vec2(at) + drawn(pixel, 0u)) / float(size);
        sum += radiance(image, drawn(pixel, 1u), drawn(pixel, 2u));
    }
    sums = uvec4(floatBitsToUint(sum), 0u);
}
