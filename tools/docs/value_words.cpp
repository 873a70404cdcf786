// SPDX-License-Identifier: MIT
#include "tools/docs/value_words.hpp"

namespace cobble::docs {

ValueWords value_words(grammar::ValueType type) {
    using enum grammar::ValueType;
    switch (type) {
        case kNumber:
            return {"number", "number"};
        case kInteger:
            return {"integer", "integer"};
        case kCount:
            return {"count", "number of members"};
        case kVector2:
            return {"vector2", "2 numbers"};
        case kVector3:
            return {"vector3", "3 numbers"};
        case kColor:
            return {"rgb", "colour"};
        case kNumbers4:
            return {"numbers4", "4 numbers"};
        case kNumbers16:
            return {"numbers16", "16 numbers"};
        case kImagePath:
            return {"path", "path of a picture"};
        case kFolderPath:
            return {"path", "path of a folder"};
        case kMeshPath:
            return {"path", "path of a mesh"};
        case kMaterialRef:
            return {"material", "number or label of a material"};
        case kTextureFilter:
            return {"filter", "`nearest` or `bilinear`"};
    }
    return {};
}

}  // namespace cobble::docs
