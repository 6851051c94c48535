import { Comer } from '../child-open-roberta.ts'
import { freeProgram } from '../projects.ts'
import { expect, opensCard, opensProject, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

/** Two networks, of which a program of Open Roberta has one, and a block that it has not. */
const several = freeProgram('Several', (make) => {
  const net = () => make.net([make.eye('2')], [make.wheel('C')], []).block
  return [make.forever(net(), net())]
})

test('a program leaves for Open Roberta, step by step', { tag: '@open-roberta' }, async ({ child }) => {
  const comer = new Comer(child)
  const dialog = child.dialog('openRoberta.title')
  const asks = async () => {
    await child.presses('lab.menu')
    await child.presses('lab.saveOpenRoberta')
    await expect(dialog).toBeVisible()
  }
  const saved = async (how: 'asItIs' | 'asSteps') =>
    (await comer.takes(() => child.presses(`openRoberta.${how}`))).text
  const texts: string[] = []
  await goesThrough(child, 'open-roberta', {
    'what is not known there': async () => {
      await opensCard(child, 'friendship')
      await asks()
    },
    'nothing is saved': () => child.types('Escape'),
    'asked again': asks,
    'with the network of Open Roberta': async () => texts.push(await saved('asSteps')),
    'asked once more': asks,
    'as it is': async () => {
      texts.push(await saved('asItIs'))
      expect(texts[0]).not.toBe(texts[1])
    },
    'two networks have no place there': async () => {
      await opensProject(child, 'Several', several)
      await asks()
    },
    'they are saved as they are': () => saved('asItIs'),
  })
})
