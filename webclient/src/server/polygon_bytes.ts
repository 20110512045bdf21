// Bytes that polygons take on the line, estimated from the frames that have arrived. A frame holds what has changed; the
// first one after a switch from pictures holds everything.

const USUAL_TRIANGLE_BYTES = 8;

export class PolygonBytes {
  private newest: { bytes: number; triangles: number } | null = null;
  private mostOfTriangle = 0;

  /** A frame has arrived. `triangles`: of the whole scene. */
  presented(bytes: number, triangles: number): void {
    this.newest = { bytes, triangles };
    if (triangles > 0) this.mostOfTriangle = Math.max(this.mostOfTriangle, bytes / triangles);
  }

  /** Forgets the frames, when another dataset is shown. */
  forget(): void {
    this.newest = null;
    this.mostOfTriangle = 0;
  }

  /** Bytes of all polygons of a scene with this many triangles. */
  all(triangles: number): number {
    return (this.mostOfTriangle > 0 ? this.mostOfTriangle : USUAL_TRIANGLE_BYTES) * triangles;
  }

  /** Bytes of the next change of a value: as many of a triangle as the newest change took. */
  change(triangles: number): number {
    const { newest } = this;
    return newest === null || newest.triangles === 0
      ? this.all(triangles)
      : (newest.bytes / newest.triangles) * triangles;
  }

  /** Triangles of the newest frame; 0 before the first. */
  get triangles(): number {
    return this.newest?.triangles ?? 0;
  }
}
