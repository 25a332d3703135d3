// Four floats at once, for what is done to millions of boxes when a tree is built, and to every
// ray. On x86-64 they are its baseline instructions; elsewhere plain code gives the same bits.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace lray::bvh {

#ifdef __SSE2__

/// Of arithmetic only the first three lanes are meant; the fourth goes along. What is read back as
/// four has to be written as four: read one by one or the other way round it comes late.
struct Float4 {
    __m128 v;

    static Float4 fill(float x) { return {_mm_set1_ps(x)}; }
    /// The fourth lane is 0.
    static Float4 of(float x, float y, float z) { return {_mm_set_ps(0.0f, z, y, x)}; }

    friend Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
    friend Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
    friend Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
};

/// b where either is NaN.
inline Float4 min(Float4 a, Float4 b) {
    return {_mm_min_ps(a.v, b.v)};
}
inline Float4 max(Float4 a, Float4 b) {
    return {_mm_max_ps(a.v, b.v)};
}

/// Reads `from[0..2]` and the four bytes behind as the first three lanes; the fourth is 0.
/// `from` is aligned to 16 bytes.
inline Float4 load_three(const float* from) {
    const __m128 kept = _mm_castsi128_ps(_mm_set_epi32(0, -1, -1, -1));
    return {_mm_and_ps(_mm_load_ps(from), kept)};
}

inline Float4 load_four(const float* from) {
    return {_mm_loadu_ps(from)};
}

/// The lanes 1, 2, 3 and 0.
inline Float4 rotated(Float4 a) {
    return {_mm_shuffle_ps(a.v, a.v, _MM_SHUFFLE(0, 3, 2, 1))};
}

/// Writes the first three lanes as `to[0..2]`.
inline void store_three_wide(double* to, Float4 a) {
    _mm_storeu_pd(to, _mm_cvtps_pd(a.v));
    _mm_store_sd(to + 2, _mm_cvtps_pd(_mm_movehl_ps(a.v, a.v)));
}

inline bool are_finite(Float4 a) {
    const __m128 nothing = _mm_sub_ps(a.v, a.v);  // NaN of what is not finite
    return _mm_movemask_ps(_mm_cmpeq_ps(nothing, nothing)) == 15;
}

/// Writes the first three lanes to `to[0..2]`, and a fourth behind.
inline void store_four(float* to, Float4 a) {
    _mm_storeu_ps(to, a.v);
}

/// The lanes cut to whole numbers. Each has to be within the range of int.
inline void store_whole(int* to, Float4 a) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_cvttps_epi32(a.v));
}

/// A bit for each lane that is not at or above the one of b: set for NaN.
inline unsigned lanes_below(Float4 a, Float4 b) {
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmpnge_ps(a.v, b.v)));
}

#else

struct Float4 {
    float v[4];

    static Float4 fill(float x) { return {{x, x, x, x}}; }
    static Float4 of(float x, float y, float z) { return {{x, y, z, 0.0f}}; }

    template <class F>
    static Float4 each(Float4 a, Float4 b, F f) {
        return {{f(a.v[0], b.v[0]), f(a.v[1], b.v[1]), f(a.v[2], b.v[2]), f(a.v[3], b.v[3])}};
    }
    friend Float4 operator+(Float4 a, Float4 b) {
        return each(a, b, [](float x, float y) { return x + y; });
    }
    friend Float4 operator-(Float4 a, Float4 b) {
        return each(a, b, [](float x, float y) { return x - y; });
    }
    friend Float4 operator*(Float4 a, Float4 b) {
        return each(a, b, [](float x, float y) { return x * y; });
    }
};

inline Float4 min(Float4 a, Float4 b) {
    return Float4::each(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline Float4 max(Float4 a, Float4 b) {
    return Float4::each(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Float4 load_three(const float* from) {
    return Float4::of(from[0], from[1], from[2]);
}
inline Float4 load_four(const float* from) {
    return {{from[0], from[1], from[2], from[3]}};
}
inline Float4 rotated(Float4 a) {
    return {{a.v[1], a.v[2], a.v[3], a.v[0]}};
}
inline void store_three_wide(double* to, Float4 a) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<double>(a.v[i]);
}
inline bool are_finite(Float4 a) {
    float nothing = 0.0f;  // what is not finite makes it NaN
    for (float number : a.v) nothing += number - number;
    return nothing == 0.0f;
}
inline void store_four(float* to, Float4 a) {
    for (int i = 0; i < 4; ++i) to[i] = a.v[i];
}
inline void store_whole(int* to, Float4 a) {
    for (int i = 0; i < 4; ++i) to[i] = static_cast<int>(a.v[i]);
}
inline unsigned lanes_below(Float4 a, Float4 b) {
    unsigned bits = 0;
    for (int i = 0; i < 4; ++i) bits |= (a.v[i] >= b.v[i] ? 0u : 1u) << i;
    return bits;
}

#endif

/// One of the first three lanes.
inline float lane(Float4 a, int index) {
    float lanes[4];
    store_four(lanes, a);
    return lanes[index];
}

}  // namespace lray::bvh
