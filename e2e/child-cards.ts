import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'

/** The node of an input or an output in the network, by its name. */
export const node = (child: Child, layer: 'showWhere' | 'showSum', name: string): Locator =>
  layer === 'showWhere'
    ? child.button('network.showWhere', { input: name })
    : child.button('network.showSum', { output: name })

/** The knob between two neurons by their names. */
export const knobOf = (child: Child, from: string, to: string): Locator =>
  child.page.getByRole('slider', { name: child.word('network.weight', { from, to }), exact: true })

/** Types a weight into a knob. */
export async function setsKnob(child: Child, from: string, to: string, weight: string) {
  await knobOf(child, from, to).focus()
  await child.types(...weight, 'Enter')
  await expect(knobOf(child, from, to)).toHaveAttribute(
    'aria-valuenow',
    String(Number(weight.replace(',', '.'))),
  )
}

/** Chooses another value in the drop-down of a block. */
export async function chooses(child: Child, block: Locator, now: string, next: string) {
  const words = (key: string) => child.word(`choice.${key}`)
  await child.press(block.getByText(words(now), { exact: true }))
  await child.press(child.page.getByRole('option', { name: words(next), exact: true }))
}

/** Opens the settings of this device from the lab's menu or from the home page. */
export async function opensSettings(child: Child, where: 'lab' | 'home') {
  if (where === 'lab') await child.presses('lab.menu')
  await child.presses('comfort.title')
  await expect(child.dialog('comfort.title')).toBeVisible()
}

/** A switch of the settings. */
export const option = (child: Child, name: 'projector' | 'quiet' | 'letters' | 'aloud'): Locator =>
  child.page.getByRole('switch', { name: child.word(`comfort.${name}`), exact: true })

/** The name of an input that sees a colour, or how much of it there is, with the sensor at the front. */
export const colourInput = (child: Child, kind: 'colour' | 'channel', colour: string): string =>
  child.word('network.name', {
    label: child.word('neuron.port', {
      label: child.word(`neuron.${kind}`, { COLOUR: child.word(`choice.${colour}`) }),
      port: '1',
    }),
    place: child.word('network.place.front'),
  })
