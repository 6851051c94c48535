import type { Block } from '@botgarten/blocks'
import type { Brain } from '@botgarten/learning/neural-network'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { hintDue } from '../hintDue.ts'
import type { CardProgram } from '../index.ts'
import { lines } from '../items/cardWords.ts'

type Words = { readonly [language: string]: RegExp }

/** Words of which a hint has one if its step is this measure. */
const named: { readonly [measure: string]: Words } = {
  '#driveDistance': { de: /Tippe auf die 50 /, en: /Tap the 50 / },
  '#experience': { de: /Versuche/, en: /tries/ },
  '#limit': { de: /statt der 0 eine Zahl/, en: /Instead of the 0, type a number/ },
  '#rightLimit': { de: /Zahlen neben ist kleiner/, en: /numbers beside is smaller/ },
  '#times': { de: /wiederholen/, en: /Repeat/ },
  '#turnDegree': { de: /Grad/, en: /degrees/ },
  ai_neural_network: { de: /Netz einsetzen/, en: /Put a network in/ },
  ai_nn_hidden_layer: { de: /Plus bei Schicht/, en: /plus at Layer/ },
  ai_nn_input_node: { de: /Sensoren/, en: /sensors/ },
  ai_nn_output_node: { de: /Plus .*(Ausgängen|Motoren)/, en: /plus .*(outputs|motors)/ },
  ai_sorting_find: { de: /sucht .*Gruppen.* Sortieren/, en: /looks for groups.* Sorting/ },
  ai_sorting_name: { de: /Gruppe einen Namen|nenne Gruppe/, en: /group a name|call group/ },
  ai_try_pay: { de: /Block für … gib/, en: /block for … pay/ },
  examples: { de: /Zeig’s mir/, en: /Show it/ },
  knobs: {
    de: /(Zieh|zieh)\b.* Kn(o|ö)pfe?\b|bringt das Signal/,
    en: /(P|p)ull\b.* knobs?\b|brings the signal/,
  },
  robActions_motorDiff_turn_for: { de: /Hol drehe /, en: /Fetch turn / },
  rounds: { de: /drück auf Üben/, en: /press Practise/ },
}

/** A road is named by its two stations. */
function wordsFor(measure: string, language: string): RegExp | undefined {
  const road = /^(\d+)-(\d+)$/.exec(measure)
  if (!road) return named[measure]?.[language]
  const [from, to] = road.slice(1).toSorted()
  return new RegExp(`(zwischen|between) ${from} (und|and) ${to}\\b`)
}

const cards = content.cards
  .map(({ id }) => ({ id, ...content.card(id)!, solution: content.program(id, 'solution')! }))
  .filter(({ card }) => card.hintSteps)

describe.each(cards)('the hints of $id', ({ card, text, start, solution }) => {
  const steps = card.hintSteps!

  it('begin with the first on the untouched card', () => {
    expect(hintDue(steps, start)).toBe(0)
  })

  it('are all followed in the solution, up to the last one that the program shows', () => {
    expect(hintDue(steps, solution)).toBe(steps.length)
  })

  it('leave one hint at least without a step: the last one tells the solution', () => {
    for (const { hints } of Object.values(text)) expect(steps.length).toBeLessThan(hints.length)
  })

  it.each(Object.keys(text))('each speak of what their step measures, in "%s"', (language) => {
    const hints = text[language]!.hints.map((hint) => lines(hint).replaceAll(/\s+/g, ' '))
    const unnamed = steps.flatMap((step, at) =>
      Object.keys(step ?? {}).filter((measure) => !wordsFor(measure, language)?.test(hints[at]!)),
    )
    expect(unnamed).toEqual([])
  })

  it('each name a measure that changes between start and solution', () => {
    for (const step of steps)
      if (step) {
        expect(hintDue([step], start)).toBe(0)
        expect(hintDue([step], solution)).toBe(1)
      }
  })
})

it('every measure that has words here is a step of some card', () => {
  const used = new Set(
    cards.flatMap(({ card }) => card.hintSteps!.flatMap((step) => Object.keys(step ?? {}))),
  )
  expect(Object.keys(named).filter((measure) => !used.has(measure))).toEqual([])
})

it('a step that no program shows counts as followed once a later one is', () => {
  const { card, start } = content.card('chameleon')!
  const green = content.program('chameleon', 'wrong/only-green')!
  const solution = content.program('chameleon', 'solution')!
  expect(hintDue([null, card.hintSteps![1]!], start)).toBe(0)
  expect(hintDue([null, card.hintSteps![1]!], solution)).toBe(2)
  expect(hintDue(card.hintSteps, green)).toBe(1)
  expect(hintDue([{ ai_nn_input_node: 3 }, { knobs: 1 }], green)).toBe(0)
})

describe('a step is not followed', () => {
  const changed = (id: string, change: (program: CardProgram) => void) => {
    const program = structuredClone(content.program(id, 'solution')!)
    change(program)
    return hintDue(content.card(id)!.card.hintSteps, program)
  }

  it('by a block that lies beside the program', () => {
    const due = changed('loud-distance', ({ programs }) => {
      const stacks = programs['main']!.stacks as unknown as { x: number; y: number; blocks: Block[] }[]
      const rest = stacks[0]!.blocks.splice(1)
      stacks.push({ x: 0, y: 0, blocks: rest })
    })
    expect(due).toBe(0)
  })

  it('by the knobs of a network that was deleted', () => {
    const due = changed('friendship', ({ brains }) => {
      const all = brains as Record<string, Brain>
      all['gone'] = all['net']!
      all['net'] = { ...all['net']!, weights: {} }
    })
    expect(due).toBe(0)
  })

  it('by practice that was never started', () => {
    const program = structuredClone(content.program('show-it', 'solution')!)
    for (const brain of Object.values(program.brains)) delete (brain as { practice?: object }).practice
    expect(hintDue([{ rounds: 1 }], program)).toBe(0)
    expect(hintDue([{ rounds: 1 }], content.program('friendship', 'start')!)).toBe(0)
  })

  it('by another road that is closed', () => {
    const other = structuredClone(content.card('railway')!.start)
    const text = JSON.stringify(content.program('railway', 'solution')).replaceAll('"FROM":"3"', '"FROM":"5"')
    expect(hintDue(content.card('railway')!.card.hintSteps, other)).toBe(0)
    expect(hintDue(content.card('railway')!.card.hintSteps, JSON.parse(text) as CardProgram)).toBe(0)
  })
})
