import { mount, unmount } from 'svelte'
import type { WorkspaceSvg } from 'blockly/core'
import { fetchWords } from '#words/message.ts'
import examples from 'content:examples'
import Explained from './Explained.svelte'

/** Opens a dialog beside the page: blocks ask for it from their menus. */
export async function explain(workspace: WorkspaceSvg, type: string): Promise<void> {
  const [all] = await Promise.all([examples(), fetchWords('editor', 'help')])
  const example = all[type]
  if (!example) return
  const onclosed = () => void unmount(dialog)
  const dialog = mount(Explained, { target: document.body, props: { workspace, type, example, onclosed } })
}
