uniform vec3 eye;
uniform sampler2DArray tiles;
centroid in vec3 p;
centroid in vec3 n;
centroid in float s;
centroid in vec2 t;
flat in vec4 c;
flat in float g;
flat in float e;
flat in int l;
out vec4 result;
void main() {
    vec3 look = normalize(eye - p);
    vec3 m = normalize(n);
    vec3 at = p + m * %(bias)f;
    float sun = 0.0;
    float seen = 0.0;
    vec3 middle = vec3(0.0);
    for (int k = 0; k < COUNT; k++) {
        float slope = dot(m, toward[k]);
        float here = slope > 0.0 ? visible(k, at) : 0.0;
        sun += here * slope;
        seen += here;
        middle += toward[k];
    }
    float shine = seen * pow(max(dot(m, normalize(normalize(middle) + look)), 0.0), 8.0 + 56.0 * g);
    vec3 light = vec3(%(sun)s) * sun / float(COUNT) + vec3(%(sky)s) * s + vec3(%(bounce)s) * (%(level)f - %(tilt)f * m.z) + e;
    vec3 texel = texture(tiles, vec3(t, max(l, 0))).rgb;
    vec3 lit = (l < 0 ? c.rgb : c.rgb * texel) * light + 0.25 * g * g * shine / float(COUNT);
    vec3 over = max(lit - %(shoulder)f, 0.0);
    vec3 bent = min(lit, %(shoulder)f) + (1.0 - %(shoulder)f) * (1.0 - exp(-over / (1.0 - %(shoulder)f)));
    vec3 curve = 1.055 * pow(max(bent, 1e-9), vec3(1.0 / 2.4)) - 0.055;
    result = vec4(mix(curve, 12.92 * bent, lessThanEqual(bent, vec3(0.0031308))), c.a);
}
