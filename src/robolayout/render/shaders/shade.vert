#version 330
uniform mat4 camera;
in vec3 position;
in vec3 normal;
in vec4 color;
in float gloss;
in float glow;
in float sky;
in vec2 uv;
in int layer;
in int id;
centroid out vec3 p;
centroid out vec3 n;
centroid out float s;
flat out vec4 c;
centroid out vec2 t;
flat out float g;
flat out float e;
flat out int l;
flat out int i;
void main() {
    p = position; n = normal; c = color; g = gloss; e = glow; s = sky; t = uv; l = layer; i = id;
    gl_Position = camera * vec4(position, 1.0);
}
