// Rooms: study, lab, q-learning, training, world
import { Builder } from '../child-build.ts'
import { Learner } from '../child-learning.ts'
import { practises } from '../child-practising.ts'
import { tasks } from '../child-solving.ts'
import { leftEye, leftWheel, rightWheel, type Child } from '../child.ts'
import { StudyHands, replayed, studyFile } from '../child-study.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

/** What a child may do in a lab, and what of it stands in the log. */
const deeds: {
  readonly [what: string]: {
    readonly card: string
    readonly events: readonly string[]
    readonly act: (child: Child) => Promise<void>
  }
} = {
  'goes back in time, turns a knob there and goes on': {
    card: 'friendship',
    events: ['knob', 'pause', 'look', 'branch'],
    act: async (child) => {
      const time = new TimeHands(child)
      await child.typesWeight(leftEye, leftWheel, 0.6)
      await child.typesWeight(leftEye, rightWheel, 0.25)
      await child.pressesStart()
      await time.opens()
      await time.runsUntil(2)
      await time.goesBack('Home', 'Shift+ArrowRight')
      await child.typesWeight(leftEye, leftWheel, 0.3)
      await child.presses('lab.continue')
      await time.runsUntil(3)
      await child.pressesStop()
    },
  },
  'lets Bo learn its way by trying, and drive it': {
    card: 'railway',
    events: ['learned', 'rebuild'],
    act: async (child) => {
      const learner = new Learner(child)
      await learner.hurries()
      await child.presses('lab.start')
      await child.seesDriving()
      await child.pressesStop()
    },
  },
  'shows examples and practises': {
    card: 'four-wrong',
    events: ['training', 'brain'],
    act: async (child) => {
      await practises(
        child,
        tasks.find(({ card }) => card.id === 'four-wrong')!,
      )
      await child.pressesStart()
      await child.seesDriving()
      await child.pressesStop()
    },
  },
  'builds a world and steps through a program': {
    card: 'free',
    events: ['rebuild', 'step'],
    act: async (child) => {
      const builder = new Builder(child)
      await builder.begins()
      await builder.addsThing('rectangle')
      await builder.ends()
      await child.steps('stepBlock')
      await child.steps('stepWorld')
      await child.presses('lab.continue')
      await child.seesDriving()
      await child.pressesStop()
    },
  },
}

for (const language of languagesOf(import.meta.filename))
  test.describe(`the log of a study in ${language}`, () => {
    test.use({ language })

    for (const [what, { card, events, act }] of Object.entries(deeds))
      test(`a child that ${what} is replayed to the same hashes`, async ({ child, page }) => {
        const hands = new StudyHands(child)
        const modules = [{ id: 'all', title: 'All', cards: [card] }]
        await hands.handsOut(studyFile({ modules, level: null, maps: null }))
        await hands.begins(1, 2)
        await hands.opensCard(card)
        await expect(child.words('study.writes')).toBeVisible()
        await act(child)
        await hands.ends()
        await hands.saysWord()
        const { path, text } = await hands.takesLogs()
        for (const event of events) expect(text).toContain(`"event":"${event}"`)
        const { runs } = replayed(path)
        expect(runs.length).toBeGreaterThan(0)
        expect(runs.filter(({ same, photo }) => !same || photo)).toEqual([])
      })
  })
