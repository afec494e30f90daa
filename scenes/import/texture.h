// Textures that have no counterpart: their mean colour stands for them.
#pragma once

#include "scenes/import/colour.h"

namespace wander {

// Of a <texture>.
Colour mean_of_texture(const XmlElement& texture, const ImportContext& context);

}  // namespace wander
