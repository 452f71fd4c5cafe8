#pragma once

namespace chiaro::app {

/// What of the project changed.
struct Change {
    enum class Kind {
        Everything,  ///< another project
        Samples,     ///< samples were added or removed, or the objects wear others
        Objects,     ///< objects are named, placed, shown or dressed otherwise, or others than before
        Strip,       ///< how sample `index` is cut from its scan
        Gradient,    ///< how the gradient of sample `index` is found
        Recoloring,  ///< the colours that sample `index` shows
        Mesh,        ///< other mesh files
        Lights,
        Occlusion,      ///< shadows and ambient occlusion
        Animation,      ///< frames, keys, turns, the render range
        Levels,         ///< how level stacks are made
        ViewAligned,    ///< how they are laid on the picture
        Method,         ///< which methods are shown
        ImageBased,     ///< how image-based textures are made
        Coherence,      ///< how their animations hang together
        ViewDependent,  ///< how textures of the objects' own views are made and blended
        Views,          ///< how views are planned
        PlacedViews,    ///< the views that the artist placed on object `index` of the scene
    };
    Kind kind = Kind::Everything;
    int index = 0;
    friend bool operator==(const Change&, const Change&) = default;
};

}  // namespace chiaro::app
