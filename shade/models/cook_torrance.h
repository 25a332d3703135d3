// The microfacet model of Cook and Torrance: mirrors whose slopes are distributed after GGX, and
// under them a matt layer that gets what they let through.
//
// Frame, measure and cosine as in reflection.h: values are pi f cos. Roughness is perceived
// roughness: alpha, the width of the distribution, is its square, and kLeastAlpha at least. Where
// two numbers are given the first one counts.
//
// Highlight: specular F D G / (4 (N.I) (N.V)), F by Schlick from `fresnel`, G of both directions
// together. Matt: diffuse (1 - specular F(N.I)) (1 - specular F(N.V)) / pi, F at the smooth
// surface: light enters and leaves through it. Symmetric, so that light goes both ways alike, and
// with specular and diffuse of 1 at most no more is reflected than arrives. Sources: Cook, Torrance
// 1982, "A Reflectance Model for Computer Graphics"; Walter et al. 2007, "Microfacet Models for
// Refraction through Rough Surfaces"; Schlick 1994, "An Inexpensive BRDF Model for Physically-based
// Rendering"; Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs";
// the product of both ways: Ashikhmin, Shirley 2000, "An Anisotropic Phong BRDF Model", without the
// factor that makes up for light going in and out again.
#pragma once

#include "shade/material_point.h"

namespace lray::shade {

Color cook_torrance_reflected(const MaterialPoint& material, const Vec3& wi, const Vec3& wo);

/// Chooses a half vector among the microfacets that wo sees; wi may point below the surface.
Vec3 cook_torrance_lobe_direction(const MaterialPoint& material, Vec3 wo, DVec2 u);
float cook_torrance_lobe_pdf(const MaterialPoint& material, Vec3 wi, Vec3 wo);

/// Estimates of what the highlight and the matt layer reflect of light from wo's direction.
Color cook_torrance_lobe_share(const MaterialPoint& material, Vec3 wo);
Color cook_torrance_diffuse_share(const MaterialPoint& material, Vec3 wo);

}  // namespace lray::shade
