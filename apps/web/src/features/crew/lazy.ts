export { default as AddRobot } from './AddRobot.svelte'
export { default as CrewBar } from './CrewBar.svelte'
export { default as TwinMarks } from './TwinMarks.svelte'
export { default as TwinNote } from './TwinNote.svelte'
