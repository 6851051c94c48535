import { content } from '@botgarten/content/files'
import { cardDocument, type CardProgram } from '@botgarten/content'
import { createLab, type Missing } from '@botgarten/lab'
import { withLearnedWay } from '@botgarten/maps'
import { TICKS_PER_SECOND } from '@botgarten/simulation'

/** Programs that are tried on a card: its own ones, and the solutions of the cards before and after it. */
function programsFor(id: string): readonly CardProgram[] {
  const { bed } = content.cards.find((one) => one.id === id)!
  const own = ['start', 'solution', ...content.wrongAnswers(id).map((name) => `wrong/${name}`)]
  const inBed = content.cards.filter((one) => one.bed === bed)
  const at = inBed.findIndex((one) => one.id === id)
  const others = [inBed[at - 1], inBed[at + 1]].filter((one) => one !== undefined)
  return [
    ...own.map((file) => content.program(id, file)!),
    ...others.map((one) => content.program(one.id, 'solution')!),
  ]
}

/** Seconds at which a run is checked. */
const looks = [0.5, 3, 12, 31, 61]

/** Misses of the runs of a card, each kind with every set of facts once. */
export function missedIn(id: string): readonly Missing[] {
  const { card, world } = content.card(id)!
  const found = new Map<string, Missing>()
  for (const program of programsFor(id)) {
    const document = withLearnedWay(cardDocument(world, card, program, 0), content.mapFile)
    const lab = createLab()
    lab.load(document, content.floorOf(document.world), { seed: 1, checks: card.checks })
    lab.start()
    const last = Math.max(31, ...card.checks.map((check) => check.seconds + 1))
    for (const seconds of looks.filter((one) => one <= last)) {
      lab.advance(Math.max(0, Math.round(seconds * TICKS_PER_SECOND) - lab.now().tick))
      for (const one of lab.missing()) found.set(JSON.stringify([one.kind, one.what, one.facts]), one)
      if (lab.now().phase !== 'running') break
    }
  }
  return [...found.values()]
}

/** Kinds that none of these runs comes to, with facts as the checks write them. */
export const rare: readonly Missing[] = [
  { check: 'lap', kind: 'laps', what: 'blind', facts: { passed: 3, all: 8 } },
  { check: 'red', kind: 'says', what: 'short', facts: { colour: '#B30006', seconds: 0.4, needed: 1 } },
  { check: 'settled', kind: 'settled', what: 'off', facts: { off: 34.56, most: 30 } },
  { check: 'white', kind: 'silent', what: 'unseen', facts: { colour: '#FFFFFF' } },
  { check: 'eyesDecide', kind: 'eyesDecide', what: 'short', facts: { seconds: 0.05, needed: 0.1 } },
  { check: 'netDecides', kind: 'netDecides', what: 'short', facts: { seconds: 0.95, needed: 2 } },
  { check: 'sings', kind: 'sings', what: 'far', facts: { least: 90 } },
]
