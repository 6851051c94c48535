// Rooms: network, inside
import type { Project } from '@botgarten/programs'
import { AskingHands } from '../child-explained.ts'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

const waits = freeProgram('Waits', (make) => [make.wait(100), make.wait(200)])

/** Types of the blocks at the head of all stacks of the file that the child saves, and of the program's own variables. */
async function heads(child: Child) {
  const project = JSON.parse(await child.savesFile()) as Project
  const [{ stacks } = { stacks: [] }] = Object.values(project.programs)
  const start = stacks.flatMap(({ blocks }) => blocks).find(({ type }) => type === 'robControls_start')
  return {
    stacks: stacks.map(({ blocks }) => blocks[0]?.type),
    variables: (start?.statements?.['ST'] ?? []).map(({ fields }) => fields?.['VAR']),
  }
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`what a block does, in ${language}`, () => {
    test.use({ language })

    test('its menu tells, draws an example, and puts it beside the program in one step', async ({
      child,
      page,
    }) => {
      const hands = new AskingHands(child)
      await child.opensProjectAtHome('Waits', waits)
      await hands.asksByMenu(child.block('b2'))
      await hands.isTold('robControls_wait_time')
      const words =
        language === 'de'
          ? /: wenn gedrückt warte 500 ms zeige 1 Spalte 0 Zeile 0$/
          : /: when starts wait 500 ms show 1 column 0 row 0$/
      await expect(hands.example).toHaveAccessibleName(words)
      await hands.takesIt()
      await expect(page.locator('.blocklyPath.blocklyActiveFocus')).toHaveCount(1)
      expect((await heads(child)).stacks).toEqual(['robControls_start', 'robControls_wait_time'])
      await page.keyboard.press('Escape')
      await child.presses('lab.undo')
      expect((await heads(child)).stacks).toEqual(['robControls_start'])
      await page.keyboard.press('Escape')
      await expect(child.button('lab.undo')).toBeDisabled()
    })

    test('so does the button beside a chosen block, and all of it goes by keys', async ({ child, page }) => {
      const hands = new AskingHands(child)
      await child.opensProjectAtHome('Waits', waits)
      await expect(child.button('editor.what')).toBeDisabled()
      await child.block('b4').click(hands.blocks.corner)
      await child.presses('editor.what')
      await hands.isTold('robControls_wait_time')
      await page.keyboard.press('Escape')
      await expect(hands.dialog).toBeHidden()

      await hands.blocks.goesTo('b2')
      await page.keyboard.press('Control+Enter')
      await expect(page.getByRole('menu')).toBeFocused()
      await page.keyboard.press('Enter')
      await hands.isTold('robControls_wait_time')
      await page.keyboard.press('Escape')
      await expect(hands.dialog).toBeHidden()
      await expect(page.locator('.blocklyPath.blocklyActiveFocus')).toHaveCount(1)
      await page.keyboard.press('Control+Enter')
      await expect(page.getByRole('menu')).toBeFocused()
      await page.keyboard.press('Enter')
      await hands.isTold('robControls_wait_time')
      await page.keyboard.press('Tab')
      await page.keyboard.press('Enter')
      await expect(hands.dialog).toBeHidden()
      expect((await heads(child)).stacks).toEqual(['robControls_start', 'robControls_wait_time'])
    })

    test('a block that still lies on the shelf tells, too: what its example makes is there once', async ({
      child,
    }) => {
      const hands = new AskingHands(child)
      await child.opensProjectAtHome('Waits', waits)
      await hands.blocks.all.click()
      for (const _ of [1, 2]) {
        await hands.blocks.row('functions').click()
        await hands.asksByMenu(hands.onShelf())
        await hands.isTold('robProcedures_defnoreturn')
        await hands.takesIt()
        await hands.blocks.row('variables').click()
        await hands.asksByMenu(hands.onShelf())
        await hands.isTold('robGlobalVariables_declare')
        await hands.takesIt()
      }
      const { stacks, variables } = await heads(child)
      expect(stacks.filter((type) => type === 'robProcedures_defnoreturn')).toHaveLength(1)
      expect(stacks.filter((type) => type === 'robProcedures_callnoreturn')).toHaveLength(2)
      expect(variables).toEqual(['x'])
    })
  })
}
