import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'

type Level = 'starter' | 'explorer' | 'expert'

/** What a child does with deeper networks and with the shelf of brains. */
export class NetHands {
  readonly child: Child

  constructor(child: Child) {
    this.child = child
  }

  async opensSettings() {
    await this.child.presses('network.settings')
  }

  level(level: Level): Locator {
    return this.child.page.getByRole('radio', { name: this.child.word(`net.levels.${level}`) })
  }

  /** Presses the word, not the small circle in front of it. */
  async chooses(level: Level) {
    await this.opensSettings()
    await this.child.press(this.child.words(`net.levels.${level}`))
    await expect(this.level(level)).toBeChecked()
    await this.child.presses('network.settings')
  }

  /** The tools of a hidden layer, counted from 1. */
  layer(layer: number): Locator {
    return this.child.page.getByRole('group', { name: this.child.word('net.layer', { layer }), exact: true })
  }

  /** A hidden neuron's node. */
  neuron(layer: number, neuron: number): Locator {
    const output = this.child.word('net.hidden', { layer, neuron })
    return this.child.button('network.showSum', { output })
  }

  /** Nodes with a sum: hidden ones and outputs. */
  get nodes(): Locator {
    const name = new RegExp(`^${this.child.word('network.showSum', { output: '.+' })}$`)
    return this.child.page.getByRole('button', { name })
  }

  bias(name: string): Locator {
    return this.child.page.getByRole('textbox', {
      name: this.child.word('net.biasOf', { name }),
      exact: true,
    })
  }

  async opensShelf() {
    await this.opensSettings()
    await this.child.presses('net.brains')
    await expect(this.child.dialog('net.brains')).toBeVisible()
  }

  async putsOnShelf(name: string) {
    await this.child.page.getByRole('textbox', { name: this.child.word('net.name'), exact: true }).fill(name)
    await this.child.presses('net.put')
    await expect(this.onShelf(name)).toBeVisible()
  }

  onShelf(name: string): Locator {
    return this.child.page.getByRole('textbox', {
      name: this.child.word('net.rename', { name }),
      exact: true,
    })
  }

  /** Chooses a file for the shelf. */
  async brings(text: string) {
    const file = { name: 'mine.brain.json', mimeType: 'application/json', buffer: Buffer.from(text) }
    await this.child.dialog('net.brains').locator('input[type=file]').setInputFiles(file)
  }

  async isTold(key: string, facts = {}) {
    const said = this.child.dialog('net.brains').getByRole('status')
    await expect(said).toHaveText(this.child.word(key, facts))
  }
}
