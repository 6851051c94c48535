import { Refusal } from './refusal.ts'

/** Of one name. */
interface Line {
  open: number
  readonly waiting: (() => void)[]
}

/** Lets a few in at the same time under each name; others wait, in their order. */
export class Slots {
  private readonly lines = new Map<string, Line>()
  private readonly most: number
  private readonly mostWaiting: number

  constructor(most: number, mostWaiting: number) {
    this.most = most
    this.mostWaiting = mostWaiting
  }

  /**
   * @returns `entered` resolves when it is let in; `end` makes room, also before that, and may be called again
   * @throws Refusal 429 if too many wait
   */
  enter(name: string): { readonly entered: Promise<void>; readonly end: () => void } {
    const line = this.lines.get(name) ?? { open: 0, waiting: [] }
    this.lines.set(name, line)
    if (line.waiting.length >= this.mostWaiting) throw new Refusal(429, 'tooManyExports', { seconds: 10 })
    let state: 'waiting' | 'open' | 'over' = 'waiting'
    let start!: () => void
    const entered = new Promise<void>((resolve) => {
      start = () => {
        line.open++
        state = 'open'
        resolve()
      }
    })
    const end = () => {
      if (state === 'over') return
      if (state === 'open') line.open--
      if (state === 'waiting') line.waiting.splice(line.waiting.indexOf(start), 1)
      state = 'over'
      this.letIn(name, line)
    }
    line.waiting.push(start)
    this.letIn(name, line)
    return { entered, end }
  }

  private letIn(name: string, line: Line) {
    while (line.open < this.most && line.waiting.length > 0) line.waiting.shift()!()
    if (line.open === 0) this.lines.delete(name)
  }
}
