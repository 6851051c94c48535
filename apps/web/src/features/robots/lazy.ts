export { default as AddRobot } from './AddRobot.svelte'
export { default as RobotsBar } from './RobotsBar.svelte'
export { default as TwinMarks } from './TwinMarks.svelte'
export { default as TwinNote } from './TwinNote.svelte'
