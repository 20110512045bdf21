// Estimates the bytes of polygons in frames, from the frames that have arrived. A frame contains only the changed
// polygons. The first frame after a switch from pictures contains all polygons.

const USUAL_TRIANGLE_BYTES = 8;

export class PolygonBytes {
  private newest: { bytes: number; triangles: number } | null = null;
  private mostOfTriangle = 0;

  /** `triangles`: number of triangles of the whole scene. */
  presented(bytes: number, triangles: number): void {
    this.newest = { bytes, triangles };
    if (triangles > 0) this.mostOfTriangle = Math.max(this.mostOfTriangle, bytes / triangles);
  }

  forget(): void {
    this.newest = null;
    this.mostOfTriangle = 0;
  }

  all(triangles: number): number {
    return (this.mostOfTriangle > 0 ? this.mostOfTriangle : USUAL_TRIANGLE_BYTES) * triangles;
  }

  /** Estimated bytes of the next change of a value: the bytes per triangle of the newest frame, times `triangles`. */
  change(triangles: number): number {
    const { newest } = this;
    return newest === null || newest.triangles === 0
      ? this.all(triangles)
      : (newest.bytes / newest.triangles) * triangles;
  }

  get triangles(): number {
    return this.newest?.triangles ?? 0;
  }
}
