import { expect } from '@playwright/test'
import { projectFile } from './projects.ts'
import type { Child } from './child.ts'
import { Pupil } from './child-class.ts'
import { TogetherHands } from './child-together.ts'
import { joins, signsIn, type Joined, type MadeClass } from './made-class.ts'
import type { ClassScreen } from './screens-class.ts'

const here = {
  ...{ card: null, project: null, checks: [], failed: 0, running: false, idle: 0 },
  ...{ size: null, pose: null, trail: [] },
}

/** A classmate whose page is open somewhere. */
async function isHere(made: MadeClass, nickname: string): Promise<Joined> {
  const mate = await joins(made, nickname)
  await mate.asker.ask('PUT', '/me/here', here)
  return mate
}

async function opensLab(child: Child, made: MadeClass): Promise<Joined> {
  const kestrel = await joins(made, 'Kestrel')
  await signsIn(child.page, made, kestrel)
  await child.opensLab('friendship')
  return kestrel
}

/** Kestrel and Otter on one program; Otter's hand is over a block. */
async function works(child: Child, made: MadeClass) {
  const otter = await isHere(made, 'Otter')
  const kestrel = await opensLab(child, made)
  const project = JSON.parse(projectFile('friendship', 'start')) as object
  await otter.asker.ask('POST', `/pair?to=${kestrel.id}`, project)
  await child.presses('class.togetherYes')
  const hands = new TogetherHands(child, made)
  await hands.seesBar()
  await child.seesLab()
  return { otter, hands }
}

async function points(child: Child, { asker }: Joined) {
  const id = await child.canvas.locator('.blocklyDraggable').nth(1).getAttribute('data-id')
  await asker.ask('PUT', '/pair/hand', { program: 'main', at: id, x: 0.3, y: 0.5, chosen: id })
}

/** Two on one program. */
export const togetherScreens: readonly ClassScreen[] = [
  {
    name: 'together-invite',
    neverPhone: true,
    async show(child, made) {
      for (const nickname of ['Otter', 'Luna', 'Nova']) await isHere(made, nickname)
      await opensLab(child, made)
      await new Pupil(child, made).opensMenu()
      await child.presses('class.together')
      await expect(child.page.getByRole('dialog').getByRole('button', { name: 'Otter' })).toBeVisible()
    },
  },
  {
    name: 'together-asked',
    neverPhone: true,
    async show(child, made) {
      const otter = await isHere(made, 'Otter')
      const kestrel = await opensLab(child, made)
      const project = JSON.parse(projectFile('friendship', 'start')) as object
      await otter.asker.ask('POST', `/pair?to=${kestrel.id}`, project)
      await expect(child.button('class.togetherYes')).toBeVisible()
    },
  },
  {
    name: 'together',
    neverPhone: true,
    async show(child, made) {
      const { otter, hands } = await works(child, made)
      await points(child, otter)
      await expect(hands.handOf('Otter')).toBeVisible()
    },
  },
  {
    name: 'together-over',
    neverPhone: true,
    async show(child, made) {
      const { otter, hands } = await works(child, made)
      await otter.asker.ask('DELETE', '/pair')
      await expect(hands.bar).toContainText(child.word('class.togetherOver', { name: 'Otter' }))
    },
  },
]
