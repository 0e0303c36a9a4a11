// Carries the precompiled headers that all rooms share.
