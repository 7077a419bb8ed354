// SPDX-License-Identifier: Apache-2.0
//
// Two and three floats: the types in which samples, points and directions are handed over.
// `RtFloat2`, `RtVector3` and their kin in RiTypesHelper.h are these types, which is why the
// members carry RenderMan's names.

#pragma once

#include <type_traits>

// <cmath> is 20,000 lines, most of what including RixRNG.h would cost, so it is left out where the
// compiler has the two functions built in.
#if !defined(__GNUC__)
#include <cmath>
#endif

namespace wellstrat {

namespace detail {

#if defined(__GNUC__)
inline float squareRoot(float x) { return __builtin_sqrtf(x); }
inline float copySign(float magnitude, float sign) { return __builtin_copysignf(magnitude, sign); }
#else
inline float squareRoot(float x) { return std::sqrt(x); }
inline float copySign(float magnitude, float sign) { return std::copysign(magnitude, sign); }
#endif

} // namespace detail

/// A 2D sample or point. Not initialised by default: arrays of it cost nothing.
struct Float2 {
    float x, y;

    Float2() = default;
    constexpr Float2(float x_, float y_) : x(x_), y(y_) {}
};

/// A 3D sample, point, vector or normal. Not initialised by default.
struct Float3 {
    float x, y, z;

    Float3() = default;
    constexpr explicit Float3(float s) : x(s), y(s), z(s) {}
    constexpr Float3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}

    constexpr float Dot(const Float3& b) const { return x * b.x + y * b.y + z * b.z; }
    constexpr Float3 Cross(const Float3& b) const {
        return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
    }
    constexpr float LengthSq() const { return Dot(*this); }
    float Length() const { return detail::squareRoot(LengthSq()); }
    /// Scales to length 1 and returns the length it had. A zero vector stays as it is.
    float Normalize();
    /// Two unit vectors that form a right-handed frame (u, v, this). This vector has length 1.
    /// Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1), listing 3.
    void CreateOrthonormalBasis(Float3& u, Float3& v) const;
};

static_assert(std::is_trivially_copyable<Float2>::value && sizeof(Float2) == 8, "two floats");
static_assert(std::is_trivially_copyable<Float3>::value && sizeof(Float3) == 12, "three floats");

constexpr Float2 operator+(Float2 a, Float2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Float2 operator-(Float2 a, Float2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Float2 operator*(Float2 a, float s) { return {a.x * s, a.y * s}; }
constexpr Float2 operator*(float s, Float2 a) { return a * s; }
constexpr bool operator==(Float2 a, Float2 b) { return a.x == b.x && a.y == b.y; }
constexpr bool operator!=(Float2 a, Float2 b) { return !(a == b); }

constexpr Float3 operator+(Float3 a, Float3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Float3 operator-(Float3 a, Float3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Float3 operator-(Float3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Float3 operator*(Float3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Float3 operator*(float s, Float3 a) { return a * s; }
constexpr Float3 operator/(Float3 a, float s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr Float3& operator+=(Float3& a, Float3 b) { return a = a + b; }
constexpr Float3& operator-=(Float3& a, Float3 b) { return a = a - b; }
constexpr Float3& operator*=(Float3& a, float s) { return a = a * s; }
constexpr Float3& operator/=(Float3& a, float s) { return a = a / s; }
constexpr bool operator==(Float3 a, Float3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
constexpr bool operator!=(Float3 a, Float3 b) { return !(a == b); }

inline float Float3::Normalize() {
    const float length = Length();
    if (length > 0.0f) *this /= length;
    return length;
}

inline void Float3::CreateOrthonormalBasis(Float3& u, Float3& v) const {
    const float sign = detail::copySign(1.0f, z);
    const float a = -1.0f / (sign + z);
    const float b = x * y * a;
    u = {1.0f + sign * x * x * a, sign * b, -sign * x};
    v = {b, sign + y * y * a, -y};
}

} // namespace wellstrat
