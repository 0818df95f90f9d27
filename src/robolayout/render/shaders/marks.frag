#version 330
uniform vec3 eye;
uniform vec3 forward;
centroid in vec3 p;
flat in int i;
layout(location = 0) out int id;
layout(location = 1) out float depth;
void main() { id = i; depth = dot(p - eye, forward); }
