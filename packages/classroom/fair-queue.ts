/** Lets requests that wait go first. */
const othersFirst = (): Promise<void> => new Promise((resolve) => setImmediate(resolve))

/** Whose turn it is: first a class, then one of its pupils. */
export interface Turn {
  readonly class: string
  readonly pupil: string
}

/** Runs a job and never rejects. */
type Job = () => Promise<void>

/** Puts an entry of a map behind all others. */
function toEnd<Value>(map: Map<string, Value>, key: string): void {
  const value = map.get(key)
  if (value === undefined) return
  map.delete(key)
  map.set(key, value)
}

/**
 * Runs one job after the other. Classes take turns, and within a class its pupils do: however many jobs one of them has, the next
 * one of another class waits for one of them at most.
 */
export class FairQueue {
  /** Jobs that wait, by class and pupil, in the order of their turns. */
  private readonly waiting = new Map<string, Map<string, Job[]>>()
  private isRunning = false

  /** @returns the result of the job */
  run<Result>({ class: classId, pupil }: Turn, job: () => Promise<Result>): Promise<Result> {
    return new Promise((resolve, reject) => {
      const pupils = this.waiting.get(classId) ?? new Map<string, Job[]>()
      this.waiting.set(classId, pupils)
      const jobs = pupils.get(pupil) ?? []
      pupils.set(pupil, jobs)
      jobs.push(() => job().then(resolve, reject))
      if (!this.isRunning) void this.work()
    })
  }

  private async work() {
    this.isRunning = true
    for (let next = this.next(); next; next = this.next()) {
      await next.job()
      this.hadTurn(next.turn)
      await othersFirst()
    }
    this.isRunning = false
  }

  private next(): { readonly job: Job; readonly turn: Turn } | null {
    for (const [classId, pupils] of this.waiting)
      for (const [pupil, jobs] of pupils) {
        const job = jobs.shift()!
        if (jobs.length === 0) pupils.delete(pupil)
        if (pupils.size === 0) this.waiting.delete(classId)
        return { job, turn: { class: classId, pupil } }
      }
    return null
  }

  /** Also those who came while the job ran are before its class, and before its pupil. */
  private hadTurn({ class: classId, pupil }: Turn): void {
    toEnd(this.waiting.get(classId) ?? new Map<string, Job[]>(), pupil)
    toEnd(this.waiting, classId)
  }
}
