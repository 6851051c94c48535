import { mount, unmount } from 'svelte'
import type { WorkspaceSvg } from 'blockly/core'
import examples from 'content:examples'
import Explained from './Explained.svelte'

/** Opens a dialog beside the page: blocks ask for it from their menus. */
export async function explain(paper: WorkspaceSvg, type: string): Promise<void> {
  const example = (await examples())[type]
  if (!example) return
  const onclosed = () => void unmount(dialog)
  const dialog = mount(Explained, { target: document.body, props: { paper, type, example, onclosed } })
}
