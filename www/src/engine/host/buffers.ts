/** Buffers that travel between the threads instead of being made anew for each frame. */
export class Buffers {
  private free: ArrayBuffer[] = []
  private away = 0

  constructor(private readonly size: number) {}

  get ready(): boolean {
    return this.away < this.size
  }

  /** A buffer of at least `bytes` bytes; ask `ready` first. */
  take(bytes: number): ArrayBuffer {
    this.away += 1
    const kept = this.free.pop()
    return kept && kept.byteLength >= bytes ? kept : new ArrayBuffer(Math.ceil(bytes * 1.25))
  }

  giveBack(buffer: ArrayBuffer): void {
    this.away = Math.max(0, this.away - 1)
    this.free.push(buffer)
  }
}
