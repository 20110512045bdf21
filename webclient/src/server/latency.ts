// Measures the time from a change until its picture is shown, and the number of pictures per second.

const WINDOW_MS = 1500;

export class Latency {
  private waiting: { revision: number; since: number }[] = [];
  private presented: { revision: number; at: number } = { revision: -1, at: 0 };
  private times: number[] = [];
  last: number | null = null;

  /** Call when the server has accepted a change made at `since`. The picture of the change may already be shown. */
  accepted(revision: number, since: number): void {
    if (this.presented.revision >= revision) this.last = Math.max(0, this.presented.at - since);
    else this.waiting.push({ revision, since });
  }

  shown(revision: number, now: number): void {
    this.times = this.times.filter((time) => now - time < WINDOW_MS);
    this.times.push(now);
    if (revision <= this.presented.revision) return; // a still picture of a revision that was already shown
    this.presented = { revision, at: now };
    const answered = this.waiting.filter((change) => change.revision <= revision);
    this.waiting = this.waiting.filter((change) => change.revision > revision);
    const newest = answered.at(-1);
    if (newest !== undefined) this.last = now - newest.since;
  }

  framesPerSecond(now: number): number {
    const recent = this.times.filter((time) => now - time < WINDOW_MS);
    const first = recent[0];
    const newest = recent.at(-1);
    if (first === undefined || newest === undefined || recent.length < 2) return 0;
    return ((recent.length - 1) * 1000) / (newest - first);
  }

  /** Forgets all measurements. Call for a new session: revisions of different sessions are not comparable. */
  reset(): void {
    this.waiting = [];
    this.presented = { revision: -1, at: 0 };
    this.times = [];
  }
}
