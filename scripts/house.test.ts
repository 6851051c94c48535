import { describe, expect, it } from 'vitest'
import { lengthsOf } from './house.ts'

const component = {
  path: 'Knob.svelte',
  text: `<script lang="ts">
  const turn = (by: number) => by * 2
  function press() {
    [1].forEach((one) => {
      turn(one)
    })
  }
</script>

<button onclick={press}>+</button>
`,
}

describe('how long the code is', () => {
  it('counts functions with statements, callbacks among them, from first word to last brace', () => {
    expect(lengthsOf([component]).functions).toEqual([5, 3])
  })

  it('counts lines of files, and those of components apart', () => {
    const file = { path: 'turn.ts', text: 'export const turn = 1\n' }
    expect(lengthsOf([component, file])).toMatchObject({ files: [10, 1], components: [10] })
  })
})
