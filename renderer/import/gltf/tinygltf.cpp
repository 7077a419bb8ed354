// SPDX-License-Identifier: Apache-2.0
//
// The code of tinygltf. Debian has a library of it too, but its libdraco, which Assimp needs,
// brings functions of the same names from another version, and a program that has both calls some
// of the one with objects of the other.

#include <fstream> // which it leaves out together with its functions for files

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
