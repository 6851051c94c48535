import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { expect, type Locator } from '@playwright/test'
import { readFile } from 'node:fs/promises'
import type { Child } from './child.ts'

/** What is written on a card that is made. */
const written = {
  title: 'Lonely square',
  story: 'The square has no friend.\n\nBo is on its way.',
  task: 'Bo stops near the square.',
  hints: ['What do the eyes see?', 'Look at the red knobs.', 'Two knobs are 0.8.'],
} as const

/** Somebody who makes a card of a project. */
export class CardMaker {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  get title() {
    return written.title
  }

  /** From a project that solves Friendship to the screen on which a card is made. */
  async begins() {
    const { card, world } = content.card('friendship')!
    const project = cardProject(world, card, content.program('friendship', 'solution')!, 'Mine')
    await this.child.opensProjectAtHome('Mine', JSON.stringify(project))
    await this.child.presses('lab.menu')
    await this.child.presses('parts.makeCard')
    await expect(this.field('cards.cardTitle')).toBeVisible()
  }

  field(label: string, facts = {}): Locator {
    return this.child.page.getByLabel(this.child.word(label, facts), { exact: true })
  }

  async writes() {
    await this.field('cards.cardTitle').fill(written.title)
    await this.field('cards.story').fill(written.story)
    await this.field('cards.task').fill(written.task)
    for (const [index, hint] of written.hints.entries())
      await this.field('cards.hint', { number: index + 1 }).fill(hint)
  }

  /** Bo has solved it from so many of all places. */
  async seesSolved(passed: number, of: number) {
    await expect(this.child.words('cards.solved', { passed, of })).toBeVisible({ timeout: 30_000 })
  }

  /** The card as a file for children. */
  async saves(): Promise<string> {
    const { page } = this.child
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      this.child.presses('cards.saveFile'),
    ])
    return readFile(await download.path(), 'utf8')
  }
}
