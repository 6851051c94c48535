import { filledRows, mapIn, mostEpisodes, mostMoves, plugged, type Block } from '@botgarten/blocks'
import type { Decay, Settings } from '@botgarten/learning/q-learning'
import type { LearningOutline, Pay, Program } from './types.ts'

const types = {
  map: 'ai_q_learning_states_and_actions_map',
  behaviour: 'ai_q_learner_config',
  experience: 'ai_q_apply_learning_rule',
  draw: 'ai_q_draw_the_best_way',
  drive: 'ai_q_drive_the_best_way',
} as const

/**
 * What a program wants to be learned by trying, read from its blocks: of every kind the first that is not switched off,
 * under a start block before those that lie about. Null without a map block.
 */
export function learningIn({ stacks }: Program): LearningOutline | null {
  const begun = stacks.filter(({ blocks }) => blocks[0]?.type === 'robControls_start')
  const all = [...begun, ...stacks.filter((stack) => !begun.includes(stack))].flatMap(({ blocks }) =>
    blocks.flatMap(inside),
  )
  const find = (type: string) => all.find((block) => block.type === type)
  const map = find(types.map)
  if (!map) return null
  const experience = find(types.experience)
  const blocks = Object.fromEntries(
    Object.entries(types).flatMap(([part, type]) => {
      const id = find(type)?.id
      return id === undefined ? [] : [[part, id]]
    }),
  ) as LearningOutline['blocks']
  return {
    blocks,
    map: mapIn(map.fields?.['MAP'] ?? ''),
    start: wholeIn(map, 'START', 0, 0),
    goal: wholeIn(map, 'FINISH', 1, 0),
    closed: closedIn(map),
    settings: settingsIn(find(types.behaviour)),
    ...payIn(map),
    // Files from elsewhere hold numbers that no field takes.
    episodes: Math.min(mostEpisodes, wholeIn(experience, 'EPISODES', 100, 1)),
    moves: Math.min(mostMoves, wholeIn(experience, 'Q_LEARNER_TIME', 10_000, 1)),
  }
}

function inside(block: Block): readonly Block[] {
  if (block.disabled === true) return []
  return [block, ...Object.values(block.statements ?? {}).flatMap((rows) => rows.flatMap(inside))]
}

function closedIn(map: Block): LearningOutline['closed'] {
  const list = plugged(map, 'OBSTACLE')
  return (list ? filledRows(list) : []).map((road) => [
    wholeIn(road, 'FROM', 2, 0),
    wholeIn(road, 'TO', 3, 0),
  ])
}

function wholeIn(block: Block | undefined, name: string, preset: number, least: number): number {
  const value = Number(block?.fields?.[name] ?? preset)
  return Number.isFinite(value) ? Math.max(least, Math.round(value)) : preset
}

/** More would drown the goal's 50. */
const MOST_PAID = 1000

function payIn({ fields = {} }: Block): Pick<LearningOutline, 'pay'> {
  const step = paid(fields['STEP_COST'])
  const own = ownIn(fields['REWARDS'])
  const pay: Pay = {
    ...(fields['LENGTH'] === 'TRUE' && { length: true as const }),
    ...(step !== 0 && { step }),
    ...(Object.keys(own).length > 0 && { own }),
  }
  return Object.keys(pay).length > 0 ? { pay } : {}
}

function paid(text = ''): number {
  const value = Number(text)
  return Number.isFinite(value) ? Math.min(MOST_PAID, Math.max(-MOST_PAID, value)) : 0
}

/** `3:10 2-5:-5`; what is not said like this is left out. */
function ownIn(text = ''): { readonly [place: string]: number } {
  const said = [...text.matchAll(/(?<=^| )(\d+(?:-\d+)?):(-?\d+(?:\.\d+)?)(?= |$)/g)]
  return Object.fromEntries(
    said.map(([, place, value]) => [place!, paid(value)] as const).filter(([, value]) => value !== 0),
  )
}

/** Own rewards as the field REWARDS holds them. */
export const ownText = (own: { readonly [place: string]: number }): string =>
  Object.entries(own)
    .map(([place, value]) => `${place}:${value}`)
    .join(' ')

/** What a child sets where no block says anything else. */
const preset: Settings = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 }

function settingsIn(block: Block | undefined): Settings {
  const share = (name: string, otherwise: number) => {
    const value = Number(block?.fields?.[name] ?? otherwise)
    return value >= 0 && value <= 1 ? value : otherwise
  }
  return {
    rules: block?.fields?.['RULES'] === 'study' ? 'study' : 'standard',
    algorithm: 'q',
    alpha: share('ALPHA', preset.alpha),
    gamma: share('GAMMA', preset.gamma),
    nu: share('NU', preset.nu),
    rho: share('RHO', preset.rho),
    ...decay('alphaDecay', block?.fields?.['ALPHA_DECAY']),
    ...decay('rhoDecay', block?.fields?.['RHO_DECAY']),
  }
}

/** '': stays as it is · `visits` (α alone) · a factor 0..1 an episode. */
function decay(name: 'alphaDecay' | 'rhoDecay', text = ''): { readonly [name: string]: Decay } {
  if (text === 'visits' && name === 'alphaDecay') return { [name]: { kind: 'visits' } }
  const factor = text.trim() === '' ? NaN : Number(text)
  return factor >= 0 && factor <= 1 ? { [name]: { kind: 'episodes', factor } } : {}
}
