import { mount } from 'svelte'
import App from './App.svelte'
import './look/page.css'
import { watchPrint } from './look/print'
import { watchLooks } from './state/looks.svelte'

watchLooks()
watchPrint()
mount(App, { target: document.getElementById('page')! })
