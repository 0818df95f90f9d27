#version 330
const int COUNT = %(count)d;
const int COLUMNS = %(columns)d;
uniform sampler2DShadow atlas;
uniform mat4 lights[COUNT];
uniform vec3 toward[COUNT];
float visible(int k, vec3 at) {
    vec3 q = (lights[k] * vec4(at, 1.0)).xyz * 0.5 + 0.5;
    if (q.x < 0.0 || q.y < 0.0 || q.x > 1.0 || q.y > 1.0) return 1.0;
    vec2 inside = clamp(q.xy, vec2(%(half)f), vec2(1.0 - %(half)f));
    vec2 tile = vec2(k - k / COLUMNS * COLUMNS, k / COLUMNS);
    return textureLod(atlas, vec3((inside + tile) / float(COLUMNS), q.z), 0.0);
}
