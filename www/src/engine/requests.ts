/** Numbers the user's requests by what they are about. With its number an answer that comes late finds out whether a newer request has replaced its own. */
export class Requests<Subject extends string> {
  private count = 0
  private readonly newest = new Map<Subject, number>()

  /** The number of a new request about these subjects. */
  note(...subjects: readonly Subject[]): number {
    this.count += 1
    for (const subject of subjects) this.newest.set(subject, this.count)
    return this.count
  }

  /** Whether there was a request about one of these subjects after number `since`. */
  replaced(since: number, ...subjects: readonly Subject[]): boolean {
    return subjects.some((subject) => (this.newest.get(subject) ?? 0) > since)
  }
}
