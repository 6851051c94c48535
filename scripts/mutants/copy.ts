import { execFileSync } from 'node:child_process'
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { Trouble } from '../prepare/run.mjs'
import type { Mutant } from './mutations.ts'
import type { Outcome } from './report.ts'
import type { Room } from './rooms.ts'
import { Warm } from './warm.ts'

const generated = ['apps/web/.svelte-kit', 'apps/web/src/words/generated']
// Tests of the server serve the built lab.
const modules = ['node_modules', 'apps/web/node_modules', 'apps/cli/node_modules', 'apps/web/build']

/** A copy of the tree as it is now, in which anything may be changed. Packages of others are linked, not copied. */
export function copyTree(from: string): string {
  const to = mkdtempSync(join(tmpdir(), 'botgarten-mutants-'))
  const files = execFileSync('git', ['ls-files', '-co', '--exclude-standard'], {
    cwd: from,
    encoding: 'utf8',
  })
  for (const file of new Set(files.trim().split('\n'))) {
    if (!existsSync(join(from, file))) continue
    mkdirSync(dirname(join(to, file)), { recursive: true })
    cpSync(join(from, file), join(to, file))
  }
  for (const folder of generated)
    if (existsSync(join(from, folder))) cpSync(join(from, folder), join(to, folder), { recursive: true })
  for (const folder of modules)
    if (existsSync(join(from, folder))) execFileSync('cp', ['-al', join(from, folder), join(to, folder)])
  writeFileSync(join(to, '.mutants'), '')
  return to
}

/** A copy of the tree with a warm Vitest in it. It is made when it is first needed. */
export class Copy {
  readonly #house: string
  #folder: string | null = null
  #warm: Warm | null = null
  /** The room whose tests have passed without any fault. */
  #trusted: Room | null = null

  private constructor(house: string) {
    this.#house = house
  }

  /** Removes the copy after `work`, also if the process gets a signal to end. */
  static async use(house: string, work: (copy: Copy) => Promise<void>): Promise<void> {
    const copy = new Copy(house)
    const stop = () => {
      copy.#remove()
      process.exit(130)
    }
    process.once('SIGINT', stop).once('SIGTERM', stop)
    try {
      await work(copy)
    } finally {
      process.off('SIGINT', stop).off('SIGTERM', stop)
      copy.#remove()
    }
  }

  #remove(): void {
    this.#warm?.close()
    if (this.#folder !== null) rmSync(this.#folder, { recursive: true, force: true })
    this.#folder = null
  }

  get #vitest(): Warm {
    this.#folder ??= copyTree(this.#house)
    return (this.#warm ??= new Warm(this.#folder))
  }

  /** @throws Trouble where the tests fail without the fault */
  async outcomeOf({ file, text }: Mutant, room: Room): Promise<Outcome> {
    if (this.#trusted !== room) await this.#refuseFailing(room)
    this.#trusted = room
    const { kind } = await this.#vitest.ask({ fault: { file, text }, ...asked(room) })
    if (kind === 'ready' || kind === 'progress') throw new Error('Vitest has started again.')
    return kind
  }

  /** Tests that fail without any fault would kill every mutant. */
  async #refuseFailing(room: Room): Promise<void> {
    for (let left = 1; ; left--) {
      const answer = await this.#vitest.ask({ fault: null, ...asked(room) })
      if (answer.kind !== 'killed' && answer.kind !== 'timeout') return
      const why = `The tests of ${room.name} fail as they are: ${'by' in answer ? answer.by : answer.kind}`
      if (left === 0) throw new Trouble(why)
      // A busy machine may have made them wait too long.
      console.log(why)
      this.#vitest.close()
    }
  }
}

const asked = ({ tests, walking }: Room) => ({ tests, walking })
