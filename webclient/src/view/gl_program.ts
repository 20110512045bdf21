// Compiles WebGL2 programs and caches the locations of their uniforms.

export interface Program {
  program: WebGLProgram;
  at(name: string): WebGLUniformLocation | null;
}

export function buildProgram(gl: WebGL2RenderingContext, vertex: string, fragment: string): Program {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type);
    if (shader === null) break; // the context is lost: nothing can be compiled
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
  }
  gl.linkProgram(program);
  if (gl.getProgramParameter(program, gl.LINK_STATUS) !== true && !gl.isContextLost()) {
    throw new Error(`The browser's WebGL rejects a shader: ${gl.getProgramInfoLog(program) ?? "no reason given"}`);
  }
  const locations = new Map<string, WebGLUniformLocation | null>();
  return {
    program,
    at(name) {
      let location = locations.get(name);
      if (location === undefined) {
        location = gl.getUniformLocation(program, name);
        locations.set(name, location);
      }
      return location;
    },
  };
}
