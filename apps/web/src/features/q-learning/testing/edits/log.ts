/** Counts of a run of random edits, and the processor time of each, as benchmarks/results/edits.md. */
export class Log {
  readonly file = new URL('../../../../../../../benchmarks/results/edits.md', here)
  readonly #started = new Map<string, number>()
  readonly #moving = new Map<string, number>()
  readonly #costs = new Map<string, number[]>()
  readonly #failures = new Map<string, number>()

  started(card: string): void {
    add(this.#started, card)
  }

  failed(cause: unknown): void {
    add(
      this.#failures,
      String(cause)
        .split('\n')[0]!
        .replace(/\d{4,}/g, '…')
        .slice(0, 400),
    )
  }

  /** Starts a measurement. The returned function ends it: milliseconds of this thread, at most those of the clock. */
  measure(): () => number {
    const [clock, before] = [performance.now(), process.threadCpuUsage()]
    return () => {
      const { user, system } = process.threadCpuUsage(before)
      return Math.min(performance.now() - clock, (user + system) / 1000 + TICK)
    }
  }

  note(kind: string, moves: boolean, milliseconds: number): void {
    if (moves) add(this.#moving, kind)
    this.#costs.set(kind, [...(this.#costs.get(kind) ?? []), milliseconds])
  }

  whileMoving = (kind: string): number => this.#moving.get(kind) ?? 0

  report({ sequences, seed }: { sequences: number; seed: number }, cards: readonly string[]): string {
    const all = [...this.#costs.values()].flat().sort((a, b) => a - b)
    const median = at(all, 0.5)
    const rows = [...this.#costs]
      .sort(([a], [b]) => (a < b ? -1 : 1))
      .map(([kind, costs]) => {
        costs.sort((a, b) => a - b)
        const times = [at(costs, 0.5), at(costs, 0.99), costs.at(-1)!].map((time) => time.toFixed(1))
        const over = costs.filter((time) => time > 20 * median).length
        return `| ${[kind, costs.length, this.whileMoving(kind), ...times, over].join(' | ')} |`
      })
    const started = cards.map((card) => this.#started.get(card) ?? 0)
    const failed = [...this.#failures].map(([text, count]) => `- ${count} sequences: ${text}`)
    return `# Random edits while a card runs

${sequences} sequences of 6 to 14 edits over the session of the lab, on a fake clock: \`BOTGARTEN_SEED=${seed} BOTGARTEN_LONG=1 npm run --silent test:unit -- apps/web/src/features/q-learning/testing/edits\`. Each sequence starts with the solution of a card, ${Math.min(...started)} to ${Math.max(...started)} times for each card.

Sequences that failed: ${[...this.#failures.values()].reduce((sum, count) => sum + count, 0)}
${failed.join('\n')}

Processor time of an edit with its effects, its notes and the next frame, in milliseconds. Median of all ${all.length} edits: ${median.toFixed(1)}, longest: ${all.at(-1)!.toFixed(1)}, ${(all.at(-1)! / median).toFixed(0)} times the median.

| edit | edits | while Bo moves | median | 99 % | longest | over 20 medians |
| --- | --: | --: | --: | --: | --: | --: |
${rows.join('\n')}
`
  }
}

/** For Vite a URL relative to \`import.meta.url\` is a file of the page. */
const here = import.meta.url

/** Resolution of the clock of a thread on Linux, in milliseconds. */
const TICK = 4

const add = (counts: Map<string, number>, key: string) => counts.set(key, (counts.get(key) ?? 0) + 1)
const at = (sorted: readonly number[], share: number) => sorted[Math.floor(sorted.length * share)] ?? 0
