import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'
import { ProofHands } from './child-proof.ts'
import { TimeHands } from './child-time.ts'

/** What a child does with what Bo learns by trying with its own sensors. */
export class TryHands {
  readonly child: Child
  readonly time: TimeHands
  readonly proof: ProofHands

  constructor(child: Child) {
    this.child = child
    this.time = new TimeHands(child)
    this.proof = new ProofHands(child)
  }

  /** The card's solution, from a file, with nothing learned yet. @param change of the text of its program */
  async opensSolution(change: (text: string) => string = (text) => text) {
    const { child } = this
    const { card } = content.card('try-dodge')!
    const { programs, brains } = content.program('try-dodge', 'solution')!
    const project = cardProject(content.world(card.world)!, card, { programs, brains }, 'Mine')
    await child.opensProjectAtHome('Mine', change(JSON.stringify(project)))
    await this.sees()
  }

  async sees() {
    await expect(this.table).toBeVisible()
  }

  get table(): Locator {
    return this.child.page.getByRole('grid', { name: this.child.word('senses.table'), exact: true })
  }

  /** A row of the table, by its number from 0. */
  row(state: number): Locator {
    return this.table.locator('tbody tr').nth(state)
  }

  cell(state: number, action: number): Locator {
    return this.row(state).getByRole('button').nth(action)
  }

  /** All numbers as they stand there. */
  numbers(): Promise<string[]> {
    return this.table.locator('tbody button').allInnerTexts()
  }

  /** How many cells nobody has tried. */
  async untried(): Promise<number> {
    return (await this.numbers()).filter((text) => text.trim() === '·').length
  }

  get lens(): Locator {
    return this.child.page.getByRole('region', { name: this.child.word('senses.lens'), exact: true })
  }

  /** The number of an edge that is typed; `eye`: left or right. */
  typedEdge(eye: 'left' | 'right', edge: 'nearBelow' | 'farFrom'): Locator {
    return this.child.page.getByRole('textbox', { name: this.#edge(eye, edge), exact: true })
  }

  /** The same on the ray. */
  edgeOnRay(eye: 'left' | 'right', edge: 'nearBelow' | 'farFrom'): Locator {
    return this.child.page.getByRole('slider', { name: this.#edge(eye, edge), exact: true })
  }

  #edge(eye: string, edge: string): string {
    const { child } = this
    const [name, label] = [child.word(`senses.eye.${eye}`), child.word(`senses.${edge}`)]
    return child.word('senses.edgeName', { name, label })
  }
}
