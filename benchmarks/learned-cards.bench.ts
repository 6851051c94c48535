import { content } from '@botgarten/content/files'
import { percentOff } from '@botgarten/learning/neural-network/train'
import { execFileSync } from 'node:child_process'
import { join } from 'node:path'
import { median, type Table } from './bench.ts'

const count = 20
const program = join(import.meta.dirname, '../apps/cli/botgarten.ts')

interface Seed {
  readonly practised: number
  readonly keptBack: number | null
  readonly starts: { readonly passed: number; readonly of: number }
}

/** What the command line says of a card's own examples, practised again with other seeds. */
function seedsOf(card: string): readonly Seed[] {
  const call = ['learn', 'net', card, '--solution', '--seeds', String(count), '--json']
  const said = execFileSync(process.execPath, [program, ...call], { encoding: 'utf8' })
  return (JSON.parse(said) as { readonly seeds: readonly Seed[] }).seeds
}

const isLearned = (id: string) =>
  Object.values(content.program(id, 'solution')!.brains).some(({ practice }) => (practice?.round ?? 0) > 0)

const spread = (losses: readonly number[]): string => {
  const off = losses.map(percentOff)
  return `${median(off).toFixed(1)} % (${Math.min(...off).toFixed(1)} to ${Math.max(...off).toFixed(1)})`
}

function rowOf(id: string): readonly (string | number)[] {
  const { code } = content.card(id)!.card
  const seeds = seedsOf(id)
  const whole = seeds.filter(({ starts }) => starts.passed === starts.of).length
  const kept = seeds.flatMap(({ keptBack }) => keptBack ?? [])
  return [
    ...[code, id, seeds[0]!.starts.of, `${whole} of ${count}`],
    ...[spread(seeds.map(({ practised }) => practised)), kept.length === 0 ? '–' : spread(kept)],
  ]
}

/** From which places Bo passes once it has practised a solution's own examples, with twenty seeds. */
export default function learnedCards(): Table {
  return {
    title: 'Cards that are learned from examples',
    how: `\`botgarten learn net CARD --solution --seeds ${count} --json\`: every solution practises its own examples again with ${count} seeds; a seed counts where Bo passes every check from every place.`,
    columns: ['card', 'id', 'places', 'seeds that pass', 'off its examples (least to most)', 'kept back'],
    rows: content.cards.filter(({ id }) => isLearned(id)).map(({ id }) => rowOf(id)),
  }
}
